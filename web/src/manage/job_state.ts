import { adviceFor } from '../page/advice';
import { element } from '../page/element';
import { formatRoute, resultsOf } from '../page/routes';
import { say, type Text } from '../words/say';

export type JobState =
    | { kind: 'sending'; share: number }
    | { kind: 'queued' | 'running' }
    | { kind: 'done'; model: number }
    | { kind: 'failed'; code: string; message: string };

const kWords: Record<'queued' | 'running' | 'done' | 'failed', Text> = {
    queued: 'waits to be indexed',
    running: 'is being indexed',
    done: 'is in the collection',
    failed: 'could not be indexed',
};

/** How far a model is on its way into the collection, as a person reads it. */
export function jobStateLine(state: JobState): (Node | string)[] {
    switch (state.kind) {
        case 'sending':
            return [
                `${Math.round(100 * state.share)} %`,
                element('progress', { max: 1, value: state.share, 'aria-label': say('Sending') }),
            ];
        case 'done': {
            const href = formatRoute(resultsOf({ kind: 'model', id: state.model }));
            return [element('a', { href }, say(kWords.done))];
        }
        case 'failed':
            return [
                say(kWords.failed),
                ' ',
                element('code', {}, state.code),
                element('p', { class: 'fine' }, state.message),
                element('p', { class: 'fine' }, say(adviceFor(state.code))),
            ];
        default:
            return [say(kWords[state.kind])];
    }
}
