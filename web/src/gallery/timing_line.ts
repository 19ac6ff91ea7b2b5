import type { SearchResult } from '../api/types';
import { element } from '../page/element';
import { formatDuration, formatName, formatPlural } from '../page/format';
import { say, sayName } from '../words/say';
import { kPipeline } from './pipeline';

/** Stages that took any time, in the order of the pipeline; what is not of it comes last. */
export function timedStages(stages: Readonly<Record<string, number>>): [string, number][] {
    const place = (stage: string): number => {
        const at = kPipeline.indexOf(stage);
        return at < 0 ? kPipeline.length : at;
    };
    return Object.entries(stages)
        .filter(([, time]) => Number.isFinite(time) && time > 0)
        .sort(([a], [b]) => place(a) - place(b));
}

/** "380 models ranked in 84 ms", and what the time went to. */
export function timingLine(result: SearchResult): HTMLElement {
    const stages = timedStages(result.stages_ms);
    return element(
        'div',
        { class: 'timing' },
        element(
            'p',
            {},
            say('{models} ranked in', { models: formatPlural(result.models, 'model', 'models') }),
            ' ',
            element('strong', {}, formatDuration(result.took_ms)),
        ),
        stages.length > 0 &&
            element(
                'ul',
                { class: 'timing-stages', 'aria-label': say('Time by stage') },
                stages.map(([name, time]) =>
                    element(
                        'li',
                        {},
                        sayName(formatName(name)),
                        ' ',
                        element('b', {}, formatDuration(time)),
                    ),
                ),
            ),
    );
}
