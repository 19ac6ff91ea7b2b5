import type { Client } from '../api/client';
import { type HeldModel, pathOf } from '../api/client';
import { isAbort } from '../api/problem';
import { copyText } from '../page/copy_text';
import { element, replace } from '../page/element';
import { problemNotice } from '../page/problem_notice';
import { say } from '../words/say';

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
    /** A page for frames in other pages. */
    embed: string | null;
}

function download(href: string, label: string, fileName: string, note = ''): HTMLElement {
    return element(
        'li',
        {},
        element('a', { href, download: fileName }, label),
        note !== '' && element('span', { class: 'fine' }, ` ${note}`),
    );
}

function copyButton(label: string, text: string): HTMLElement {
    const button = element('button', { type: 'button', class: 'link-button' }, label);
    button.addEventListener('click', async () => {
        const copied = await copyText(text);
        button.textContent = say(copied ? 'Copied' : 'The browser does not allow it');
    });
    return button;
}

/** What another page writes to show the model. */
function frameFor(embed: string): string {
    return `<iframe src="${new URL(embed, location.href)}" width="480" height="360"></iframe>`;
}

function list(
    { model, name, path }: TakeAwayOptions,
    { file, stl, fullRig, embed }: Files,
): HTMLElement {
    const at = pathOf(model);
    return element(
        'ul',
        { class: 'take-away-list' },
        path !== '' &&
            element(
                'li',
                {},
                element('code', {}, path),
                ' ',
                copyButton(say('Copy the path'), path),
            ),
        file && download(file, say('The file itself'), ''),
        stl && download(stl, 'STL', `${name}.stl`, say('all triangles')),
        fullRig && download(fullRig, say('Rigged glTF'), `${name}.glb`, say('all triangles')),
        !fullRig &&
            download(`${at}/rig.glb`, say('Rigged glTF'), `${name}.glb`, say('of the preview')),
        download(`${at}/skeleton`, say('Skeleton'), `${name}-skeleton.json`),
        download(`${at}/segments`, say('Parts'), `${name}-parts.json`),
        embed &&
            element('li', {}, copyButton(say('Copy the frame for another page'), frameFor(embed))),
    );
}

async function filesOf(model: HeldModel, client: Client, signal: AbortSignal): Promise<Files> {
    const rig = `${pathOf(model)}/rig.glb?detail=full`;
    if (model.kind === 'query') {
        return { file: null, stl: `${pathOf(model)}/mesh.stl`, fullRig: rig, embed: null };
    }
    const { links } = await client.model(model.id, signal);
    const file = links.file ?? null;
    return {
        file,
        stl: links.stl ?? null,
        fullRig: file && rig,
        embed: links.embed ?? null,
    };
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
            say('Take away'),
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
