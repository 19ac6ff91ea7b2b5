import 'uplot/dist/uPlot.min.css';
import uPlot from 'uplot';

import type { Evaluation } from '../api/types';
import { element } from '../page/element';
import { formatName, formatShare } from '../page/format';
import { rankerColor } from './ranker_color';
import { alignCurves } from './report_data';
import { say, sayName } from '../words/say';

export interface CurveChart {
    node: HTMLElement;
    dispose(): void;
}

const kHeight = 380;
const kLeastWidth = 240;

function chartOptions(evaluations: readonly Evaluation[], width: number): uPlot.Options {
    const styles = getComputedStyle(document.documentElement);
    const ink = styles.getPropertyValue('--ink-muted').trim() || '#666666';
    const line = styles.getPropertyValue('--line').trim() || '#dddddd';
    const font = `12px ${getComputedStyle(document.body).fontFamily || 'sans-serif'}`;
    const axis = (label: string, size: number): uPlot.Axis => ({
        label,
        labelFont: font,
        font,
        stroke: ink,
        size,
        labelSize: 22,
        grid: { stroke: line, width: 1 },
        ticks: { show: false },
        values: (_, marks) => marks.map((mark) => mark.toFixed(1)),
        incrs: [0.1, 0.2, 0.5],
    });
    return {
        width,
        height: kHeight,
        scales: {
            x: { time: false, range: [0, 1] },
            y: { range: [0, 1.02] },
        },
        axes: [axis(say('Recall'), 34), axis(say('Precision'), 40)],
        cursor: { points: { size: 8 }, drag: { x: false, y: false } },
        legend: { live: true },
        series: [
            {
                label: say('Recall'),
                value: (_, value: number | null) => (value === null ? '–' : value.toFixed(2)),
            },
            ...evaluations.map(
                (evaluation): uPlot.Series => ({
                    label: sayName(formatName(evaluation.ranker)),
                    stroke: rankerColor(evaluation.ranker),
                    width: 2.25,
                    spanGaps: true,
                    points: { show: true, size: 5, fill: rankerColor(evaluation.ranker) },
                    value: (_, value: number | null) => (value === null ? '–' : formatShare(value)),
                }),
            ),
        ],
    };
}

/** Precision over recall, a line for each ranker. Follows its width and the page's colours. */
export function curveChart(evaluations: readonly Evaluation[]): CurveChart {
    const { recall, precision } = alignCurves(evaluations);
    const names = evaluations
        .map((evaluation) => sayName(formatName(evaluation.ranker)))
        .join(', ');
    const node = element('div', {
        class: 'curve',
        role: 'img',
        'aria-label': say('Precision over recall of {names}; the table below has the figures', {
            names,
        }),
    });
    let chart: uPlot | null = null;
    const draw = (): void => {
        const width = Math.max(kLeastWidth, node.clientWidth);
        chart?.destroy();
        chart = new uPlot(chartOptions(evaluations, width), [recall, ...precision], node);
    };
    const resized = new ResizeObserver(() => {
        const width = Math.max(kLeastWidth, node.clientWidth);
        if (!chart) {
            draw();
        } else if (chart.width !== width) {
            chart.setSize({ width, height: kHeight });
        }
    });
    resized.observe(node);
    const dark = matchMedia('(prefers-color-scheme: dark)');
    dark.addEventListener('change', draw);
    return {
        node,
        dispose() {
            resized.disconnect();
            dark.removeEventListener('change', draw);
            chart?.destroy();
        },
    };
}
