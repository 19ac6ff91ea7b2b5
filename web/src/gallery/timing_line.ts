import type { SearchResult } from '../api/types';
import { element } from '../page/element';
import { formatDuration, formatName, formatPlural } from '../page/format';

/** Stages that took any time, in the order of the pipeline. */
export function timedStages(stages: Readonly<Record<string, number>>): [string, number][] {
    return Object.entries(stages).filter(([, time]) => Number.isFinite(time) && time > 0);
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
            `${formatPlural(result.models, 'model')} ranked in `,
            element('strong', {}, formatDuration(result.took_ms)),
        ),
        stages.length > 0 &&
            element(
                'ul',
                { class: 'timing-stages', 'aria-label': 'Time by stage' },
                stages.map(([name, time]) =>
                    element(
                        'li',
                        {},
                        formatName(name),
                        ' ',
                        element('b', {}, formatDuration(time)),
                    ),
                ),
            ),
    );
}
