import type { Client } from '../api/client';
import { type HeldModel, pathOf } from '../api/client';
import { isAbort } from '../api/problem';
import { element, replace } from '../page/element';
import { problemNotice } from '../page/problem_notice';

export interface TakeAwayOptions {
    model: HeldModel;
    name: string;
    /** Below the folder that was indexed; empty: it has none. */
    path: string;
}

/** What can be had only of files, which a server gives away or not. */
interface Files {
    file: string | null;
    stl: string | null;
    fullRig: string | null;
}

function download(href: string, label: string, fileName: string, note = ''): HTMLElement {
    return element(
        'li',
        {},
        element('a', { href, download: fileName }, label),
        note !== '' && element('span', { class: 'fine' }, ` ${note}`),
    );
}

function copyButton(path: string): HTMLElement {
    const button = element('button', { type: 'button', class: 'link-button' }, 'Copy the path');
    button.addEventListener('click', () => {
        const said = (text: string): void => {
            button.textContent = text;
        };
        navigator.clipboard?.writeText(path).then(
            () => said('Copied'),
            () => said('The browser does not allow it'),
        ) ?? said(path);
    });
    return button;
}

function list({ model, name, path }: TakeAwayOptions, { file, stl, fullRig }: Files): HTMLElement {
    const at = pathOf(model);
    return element(
        'ul',
        { class: 'take-away-list' },
        path !== '' && element('li', {}, element('code', {}, path), ' ', copyButton(path)),
        file && download(file, 'The file itself', ''),
        stl && download(stl, 'STL', `${name}.stl`, 'all triangles'),
        fullRig && download(fullRig, 'Rigged glTF', `${name}.glb`, 'all triangles'),
        !fullRig && download(`${at}/rig.glb`, 'Rigged glTF', `${name}.glb`, 'of the preview'),
        download(`${at}/skeleton`, 'Skeleton', `${name}-skeleton.json`),
        download(`${at}/segments`, 'Parts', `${name}-parts.json`),
    );
}

async function filesOf(model: HeldModel, client: Client, signal: AbortSignal): Promise<Files> {
    const rig = `${pathOf(model)}/rig.glb?detail=full`;
    if (model.kind === 'query') {
        return { file: null, stl: `${pathOf(model)}/mesh.stl`, fullRig: rig };
    }
    const { links } = await client.model(model.id, signal);
    const file = links.file ?? null;
    return { file, stl: links.stl ?? null, fullRig: file && rig };
}

/** Where a model lies and what of it can be saved, once one asks. */
export function takeAway(options: TakeAwayOptions, client: Client): HTMLElement {
    const body = element('div', {});
    const node = element(
        'details',
        { class: 'take-away' },
        element(
            'summary',
            {},
            'Take away',
            element('span', { class: 'visually-hidden' }, ` ${options.name}`),
        ),
        body,
    );
    let running: AbortController | null = null;
    const fill = async (): Promise<void> => {
        running?.abort();
        running = new AbortController();
        const { signal } = running;
        try {
            replace(body, list(options, await filesOf(options.model, client, signal)));
        } catch (error) {
            if (!isAbort(error)) {
                replace(body, problemNotice(error, { retry: () => void fill() }));
            }
        }
    };
    node.addEventListener('toggle', () => {
        if (node.open && body.childElementCount === 0) {
            void fill();
        }
    });
    return node;
}
