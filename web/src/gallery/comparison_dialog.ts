import type { Client } from '../api/client';
import type { PreviewMesh, QueryModel, UpAxis } from '../api/elements';
import type { Hit } from '../api/types';
import { codePart } from '../page/code_part';
import { element } from '../page/element';
import { formatDistance } from '../page/format';
import { formatRoute, resultsOf } from '../page/routes';
import { say } from '../words/say';
import { branchFile } from './part_query';
import { partsList } from './parts_list';
import type { Nearness } from './nearness';
import { placeLine } from './place_line';
import { takeAway } from './take_away';
import { whyLine } from './why_line';
import { type ViewerDialog, viewerDialog } from './viewer_dialog';

export interface ComparisonOptions {
    query: QueryModel;
    queryMesh: PreviewMesh | null;
    queryUp: UpAxis;
    hit: Hit;
    nearness: Nearness | null;
    partsHref: string;
    lookHref: string;
    /** To the hit one rank better; null: there is none. */
    onPrevious: (() => void) | null;
    onNext: (() => void) | null;
    /** Searches for models that have what a file holds. */
    onFind: (part: File) => void;
    onClose: () => void;
}

interface Step {
    id: string;
    label: string;
    sign: string;
}

/** Keeps its place and the focus where there is no further hit. */
function step(onStep: (() => void) | null, { id, label, sign }: Step): HTMLElement {
    return element(
        'button',
        {
            type: 'button',
            id,
            class: `button button-icon${onStep ? '' : ' button-off'}`,
            'aria-label': label,
            'aria-disabled': onStep ? null : 'true',
            click: () => onStep?.(),
        },
        sign,
    );
}

/** Query and hit side by side. */
export function comparisonDialog(options: ComparisonOptions, client: Client): ViewerDialog {
    const {
        query,
        queryMesh,
        queryUp,
        hit,
        nearness,
        partsHref,
        lookHref,
        onPrevious,
        onNext,
        onFind,
        onClose,
    } = options;
    const model = { kind: 'model', id: hit.id } as const;
    return viewerDialog({
        keys: { ArrowLeft: onPrevious, ArrowRight: onNext },
        title: [
            element('span', {}, query.name),
            element('span', { class: 'versus', 'aria-label': say('and') }, '↔'),
            element('span', {}, hit.name),
            hit.class && element('span', { class: 'tag' }, hit.class),
            placeLine(hit.path),
        ],
        actions: [
            element(
                'span',
                { class: 'distance-figure' },
                nearness && [element('b', {}, say(nearness)), ' · '],
                say('distance'),
                ' ',
                element('b', { class: 'number' }, formatDistance(hit.distance)),
            ),
            element(
                'a',
                { class: 'button', href: formatRoute(resultsOf(model)) },
                say('Find more like it'),
            ),
            element('a', { class: 'button', href: lookHref }, say('Look closer')),
            element('a', { class: 'button', href: partsHref }, say('Its parts')),
            takeAway({ model, name: hit.name, path: hit.path }, client),
            step(onPrevious, { id: 'better-hit', label: say('Better hit'), sign: '←' }),
            step(onNext, { id: 'next-hit', label: say('Next hit'), sign: '→' }),
        ],
        async load(signal) {
            const [{ comparison }, mesh, skeleton, { up, unit }] = await Promise.all([
                codePart(() => import('../viewer/comparison')),
                client.mesh(model, signal),
                client.skeleton(model, signal),
                client.model(hit.id, signal),
            ]);
            return comparison({
                query: {
                    name: query.name,
                    mesh: queryMesh,
                    skeleton: query.skeleton,
                    up: queryUp,
                    unit: query.unit,
                },
                hit: { name: hit.name, mesh, skeleton, up, unit },
                match: hit.match,
                onFind: (branch) =>
                    onFind(branchFile(say('{name}, branch', { name: query.name }), branch)),
                note: element(
                    'div',
                    { class: 'note' },
                    whyLine(hit, query.skeleton, nearness),
                    partsList(hit.parts),
                ),
            });
        },
        onClose,
    });
}
