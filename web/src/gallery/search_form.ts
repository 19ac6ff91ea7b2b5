import { kRankers } from '../api/elements';
import { kLimits, kSearchDefaults, type SearchParameters } from '../api/search_parameters';
import type { Ranker } from '../api/types';
import { type Child, element } from '../page/element';
import { capitalise, formatName } from '../page/format';
import type { KnownFacets } from '../page/known_facets';
import { sayName, say, type Text } from '../words/say';
import { knownFacetField } from './known_facet_field';

export interface SearchFormOptions {
    parameters: SearchParameters;
    /** Called once a choice is made, not for each step of the slider. */
    onChange: (parameters: SearchParameters) => void;
}

const kDefaults: SearchFormOptions = { parameters: kSearchDefaults, onChange: () => {} };

export interface SearchForm {
    node: HTMLElement;
    readonly parameters: SearchParameters;
    dispose(): void;
}

const kRankerHints: Record<Ranker, Text> = {
    hybrid: 'Skeleton and overall shape together',
    skeleton: 'Skeleton matching alone',
    'chain-code': 'Chain codes alone',
};

let forms = 0;

function rankerChoice(name: string, chosen: Ranker): HTMLFieldSetElement {
    return element(
        'fieldset',
        { class: 'field segmented-field' },
        element('legend', { class: 'field-label' }, say('Ranker')),
        element(
            'div',
            { class: 'segmented' },
            kRankers.map((ranker) =>
                element(
                    'label',
                    { title: say(kRankerHints[ranker]) },
                    element('input', {
                        type: 'radio',
                        name,
                        value: ranker,
                        checked: ranker === chosen,
                    }),
                    element('span', {}, capitalise(sayName(formatName(ranker)))),
                ),
            ),
        ),
    );
}

function field(label: string, ...control: Child[]): HTMLElement {
    return element(
        'label',
        { class: 'field' },
        element('span', { class: 'field-label' }, label),
        ...control,
    );
}

function poseField(pose: HTMLInputElement, value: HTMLOutputElement): HTMLElement {
    return element(
        'label',
        { class: 'field' },
        element('span', { class: 'field-label' }, say('Build or pose'), value),
        pose,
        element(
            'span',
            { class: 'range-ends', 'aria-hidden': 'true' },
            element('span', {}, say('built like it')),
            element('span', {}, say('standing like it')),
        ),
    );
}

function choice(box: HTMLInputElement, text: string): HTMLElement {
    return element('label', { class: 'switch' }, box, element('span', {}, text));
}

/** How to search: everything but the query itself. */
export function searchForm(
    facets: KnownFacets,
    options: Partial<SearchFormOptions> = {},
): SearchForm {
    const { parameters, onChange } = { ...kDefaults, ...options };
    forms += 1;
    const rankers = rankerChoice(`ranker-${forms}`, parameters.ranker);
    const pose = element('input', {
        type: 'range',
        min: 0,
        max: 1,
        step: 0.05,
        value: parameters.pose,
        name: 'pose',
    });
    const poseValue = element('output', { class: 'field-value' }, parameters.pose.toFixed(2));
    const limits = [...new Set([...kLimits, parameters.limit])].sort((a, b) => a - b);
    const limit = element(
        'select',
        { class: 'input', name: 'limit' },
        limits.map((count) => element('option', { value: count }, count)),
    );
    limit.value = String(parameters.limit);
    const rerank = element('input', {
        type: 'checkbox',
        name: 'rerank',
        checked: parameters.rerank,
    });
    const part = element('input', { type: 'checkbox', name: 'part', checked: parameters.part });
    const fold = element('input', { type: 'checkbox', name: 'fold', checked: parameters.fold });
    const size = element('input', {
        type: 'checkbox',
        name: 'size',
        checked: parameters.size > 0,
    });
    const className = knownFacetField('classes', parameters.className, facets);
    const folder = knownFacetField('folders', parameters.folder, facets);
    const kind = knownFacetField('kinds', parameters.kind, facets);
    const node = element(
        'form',
        { class: 'search-form', 'aria-label': say('Search options') },
        rankers,
        poseField(pose, poseValue),
        className.node,
        folder.node,
        kind.node,
        field(say('Hits'), limit),
        choice(part, say('As a part: models that have this somewhere')),
        choice(size, say('Size counts (models of one unit)')),
        choice(rerank, say('Re-rank by what the collection has in common')),
        choice(fold, say('Copies of a model are one hit')),
    );
    const read = (): SearchParameters => ({
        ranker: (rankers.querySelector<HTMLInputElement>('input:checked')?.value ??
            parameters.ranker) as Ranker,
        pose: Number(pose.value),
        size: size.checked ? 1 : 0,
        rerank: rerank.checked,
        part: part.checked,
        fold: fold.checked,
        limit: Number(limit.value),
        className: className.select.value,
        folder: folder.select.value,
        kind: kind.select.value,
        order: parameters.order,
    });
    pose.addEventListener('input', () => {
        poseValue.textContent = Number(pose.value).toFixed(2);
    });
    node.addEventListener('change', () => onChange(read()));
    node.addEventListener('submit', (event) => {
        event.preventDefault();
        onChange(read());
    });
    return {
        node,
        get parameters() {
            return read();
        },
        dispose() {
            for (const each of [className, folder, kind]) {
                each.dispose();
            }
        },
    };
}
