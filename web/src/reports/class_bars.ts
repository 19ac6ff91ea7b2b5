import type { Evaluation, Metrics } from '../api/types';
import { element, replace } from '../page/element';
import { capitalise, formatName, formatShare } from '../page/format';
import { saveText } from '../page/save_file';
import { say, sayName } from '../words/say';
import { barsSvg } from './bars_svg';
import { rankerColor, rankerColorName } from './ranker_color';
import { kMetrics } from './report_data';

function classNames(evaluations: readonly Evaluation[]): string[] {
    const names = new Set(evaluations.flatMap(({ per_class }) => Object.keys(per_class)));
    return [...names].sort((a, b) => a.localeCompare(b, 'en', { numeric: true }));
}

function bar({ ranker, per_class }: Evaluation, name: string, key: keyof Metrics): HTMLElement {
    const share = per_class[name]?.[key];
    const spoken = `${sayName(formatName(ranker))} ${formatShare(share ?? Number.NaN)}`;
    return element(
        'span',
        { class: 'class-bar', role: 'img', 'aria-label': spoken, title: spoken },
        element('span', {
            '--share': (share ?? 0).toFixed(4),
            '--color': `var(${rankerColorName(ranker)})`,
        }),
    );
}

/** One measure class by class, a bar for each ranker. */
export function classBars(evaluations: readonly Evaluation[]): HTMLElement {
    const names = classNames(evaluations);
    const select = element(
        'select',
        { class: 'input' },
        kMetrics.map(({ key, long }) => element('option', { value: key }, say(long))),
    );
    const rows = element('dl', { class: 'class-bars' });
    const chosen = (): keyof Metrics =>
        kMetrics.find(({ key }) => key === select.value)?.key ?? 'nearest_neighbor';
    const show = (): void => {
        const key = chosen();
        replace(
            rows,
            names.map((name) =>
                element(
                    'div',
                    {},
                    element('dt', {}, name),
                    element(
                        'dd',
                        {},
                        evaluations.map((each) => bar(each, name, key)),
                    ),
                ),
            ),
        );
    };
    select.addEventListener('change', show);
    show();
    const save = (): void => {
        const series = evaluations.map(({ ranker, per_class }) => ({
            name: formatName(ranker),
            color: rankerColor(ranker),
            values: names.map((name) => per_class[name]?.[chosen()] ?? 0),
        }));
        saveText(`classes-${chosen()}.svg`, 'image/svg+xml', barsSvg(names, series));
    };
    return element(
        'div',
        { class: 'class-bars-panel' },
        element(
            'div',
            { class: 'report-tools' },
            element(
                'label',
                { class: 'field' },
                element('span', { class: 'field-label' }, say('Measure of quality')),
                select,
            ),
            element(
                'ul',
                { class: 'legend' },
                evaluations.map(({ ranker }) =>
                    element(
                        'li',
                        {},
                        element('span', {
                            class: 'swatch',
                            '--color': `var(${rankerColorName(ranker)})`,
                        }),
                        capitalise(sayName(formatName(ranker))),
                    ),
                ),
            ),
            element(
                'button',
                { type: 'button', class: 'link-button', click: save },
                say('Save as SVG'),
            ),
        ),
        rows,
    );
}
