import { element } from '../page/element';
import { formatLength } from '../page/format';
import { saveFile } from '../page/save_file';
import { say, type Text } from '../words/say';
import { kFirstOrbit, kStandardViews, type StandardView, standardView } from './orbit';
import type { Pane, PaneLook, Section } from './pane';
import { toggle } from './toggle';

export interface LookControlsOptions {
    panes: readonly LookedAt[];
    /** What fills the screen when that is asked for. */
    stage: HTMLElement;
    /** Between the switches that are always there and those that are folded away. */
    more: HTMLElement[];
}

export interface LookedAt {
    pane: Pane;
    name: string;
    /** Of its lengths; null: its file names none. */
    unit: string | null;
}

function button(label: string, click: () => void): HTMLElement {
    return element('button', { type: 'button', class: 'button button-quiet', click }, label);
}

function labelled(label: string, ...controls: HTMLElement[]): HTMLElement {
    return element('label', { class: 'look-field' }, element('span', {}, label), ...controls);
}

function choice(options: readonly [value: string, label: string][]): HTMLSelectElement {
    return element(
        'select',
        { class: 'input' },
        options.map(([value, label]) => element('option', { value }, label)),
    );
}

const kViewNames: Record<StandardView, Text> = {
    Front: 'Front',
    Back: 'Back',
    Left: 'Left',
    Right: 'Right',
    Top: 'Top',
    Bottom: 'Bottom',
};

function viewField(panes: readonly LookedAt[]): HTMLElement {
    const names = Object.keys(kStandardViews) as StandardView[];
    const select = choice([
        ['', say('Free')],
        ...names.map((name): [string, string] => [name, say(kViewNames[name])]),
    ]);
    select.addEventListener('change', () => {
        const view = names.find((name) => name === select.value);
        for (const { pane } of panes) {
            const { orbit } = pane;
            orbit.set(view ? standardView(view, orbit.orbit) : { ...kFirstOrbit });
        }
    });
    return labelled(say('View from'), select);
}

function sectionField(show: (look: Partial<PaneLook>) => void): HTMLElement {
    const axis = choice([
        ['', say('Off')],
        ['0', 'x'],
        ['1', 'y'],
        ['2', 'z'],
    ]);
    const place = element('input', {
        type: 'range',
        min: -1,
        max: 1,
        step: 0.02,
        value: 0,
        'aria-label': say('Where it is cut'),
        disabled: true,
    });
    const cut = (): void => {
        place.disabled = axis.value === '';
        const section: Section | null =
            axis.value === ''
                ? null
                : { axis: Number(axis.value) as Section['axis'], at: Number(place.value) };
        show({ section });
    };
    axis.addEventListener('change', cut);
    place.addEventListener('input', cut);
    return element('div', { class: 'look-fields' }, labelled(say('Cut across'), axis), place);
}

function measureSwitch(panes: readonly LookedAt[], said: HTMLElement): HTMLElement {
    return toggle(say('Measure'), false, (on) => {
        const hint = say('Press two points of the surface (Enter: the middle of the picture).');
        said.textContent = on ? hint : '';
        for (const { pane, name, unit } of panes) {
            pane.measure(
                on
                    ? (length) => {
                          said.textContent =
                              length === null ? hint : `${name}: ${formatLength(length, unit)}`;
                      }
                    : null,
            );
        }
    });
}

async function takePictures(panes: readonly LookedAt[]): Promise<void> {
    for (const { pane, name } of panes) {
        const picture = await pane.snapshot();
        if (picture) {
            saveFile(`${name}.png`, picture);
        }
    }
}

function fullScreen(stage: HTMLElement): void {
    if (document.fullscreenElement) {
        void document.exitFullscreen();
    } else {
        void stage.requestFullscreen?.();
    }
}

/** How models are looked at: the same for one alone and for two beside each other. */
export function lookControls({ panes, stage, more }: LookControlsOptions): HTMLElement {
    const said = element('output', { class: 'look-said' });
    const show = (look: Partial<PaneLook>): void => {
        for (const { pane } of panes) {
            pane.show(look);
        }
    };
    const opacity = element('input', { type: 'range', min: 0, max: 1, step: 0.05, value: 0.2 });
    opacity.addEventListener('input', () => show({ opacity: Number(opacity.value) }));
    const reset = (): void => {
        for (const { pane } of panes) {
            pane.orbit.set({ ...kFirstOrbit });
        }
    };
    return element(
        'div',
        { class: 'viewer-controls', role: 'group', 'aria-label': say('View') },
        ...more,
        toggle(say('Surface'), true, (surface) => show({ surface })),
        toggle(say('Nodes'), true, (nodes) => show({ nodes })),
        measureSwitch(panes, said),
        element(
            'details',
            { class: 'look-more' },
            element('summary', {}, say('More')),
            element(
                'div',
                { class: 'look-panel' },
                toggle(say('Wireframe'), false, (wireframe) => show({ wireframe })),
                toggle(say('Bounding box'), false, (box) => show({ box })),
                toggle(say('Orthographic'), false, (orthographic) => show({ orthographic })),
                labelled(say('Opacity'), opacity),
                viewField(panes),
                sectionField(show),
            ),
        ),
        said,
        element(
            'span',
            { class: 'viewer-buttons' },
            button(say('Save picture'), () => void takePictures(panes)),
            document.fullscreenEnabled && button(say('Full screen'), () => fullScreen(stage)),
            button(say('Reset view'), reset),
        ),
    );
}
