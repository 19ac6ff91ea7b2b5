import type { Client } from '../api/client';
import { codePart } from '../page/code_part';

/** Who only passes over a card wants nothing of it. */
const kPauseMs = 280;

/**
 * Turns the model of the card that a mouse rests on, in the place of its picture. Only one at a time,
 * and none for those who want no motion.
 */
export function turntableHover(root: HTMLElement, client: Client): () => void {
    const undo = new AbortController();
    const { signal } = undo;
    let card: Element | null = null;
    let pause: ReturnType<typeof setTimeout> | undefined;
    let running = new AbortController();
    let end: () => void = () => {};
    const stop = (): void => {
        clearTimeout(pause);
        running.abort();
        end();
        end = () => {};
        card = null;
    };
    const start = async (host: HTMLElement, id: number): Promise<void> => {
        running = new AbortController();
        const { signal: wanted } = running;
        const model = { kind: 'model', id } as const;
        try {
            const [{ turntable }, mesh, { up }] = await Promise.all([
                codePart(() => import('../viewer/turntable')),
                client.mesh(model, wanted),
                client.model(id, wanted),
            ]);
            if (!wanted.aborted) {
                end = turntable(host, mesh, up);
            }
        } catch {
            // The picture stays as it is.
        }
    };
    const rest = (event: PointerEvent): void => {
        const over = (event.target as Element).closest('[data-model]');
        if (over === card) {
            return;
        }
        stop();
        const host = over?.querySelector<HTMLElement>('.thumbnail');
        const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
        if (!over || !host || event.pointerType !== 'mouse' || still) {
            return;
        }
        card = over;
        const id = Number(over.getAttribute('data-model'));
        pause = setTimeout(() => void start(host, id), kPauseMs);
    };
    // Who rests on a card already moves a little at some time.
    root.addEventListener('pointerover', rest, { signal });
    root.addEventListener('pointermove', rest, { signal });
    root.addEventListener('pointerleave', stop, { signal });
    return () => {
        undo.abort();
        stop();
    };
}
