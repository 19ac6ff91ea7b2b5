import type { Administration } from '../api/administration';
import type { Chosen } from '../page/selection';

/** So long one may think better of it. */
export const kUndoMs = 10_000;

/** A removal that happens once its time is up, unless it is taken back before. */
export class PendingRemoval {
    readonly models: readonly Chosen[];
    private readonly timer_: ReturnType<typeof setTimeout>;
    private readonly began_ = Date.now();
    private over_ = false;

    /** @param onDone told what failed; null: nothing did */
    constructor(
        models: readonly Chosen[],
        administration: Administration,
        onDone: (error: unknown, removed: readonly Chosen[]) => void,
    ) {
        this.models = models;
        this.timer_ = setTimeout(async () => {
            this.over_ = true;
            const removed: Chosen[] = [];
            try {
                for (const model of models) {
                    await administration.remove(model.id);
                    removed.push(model);
                }
                onDone(null, removed);
            } catch (error) {
                onDone(error, removed);
            }
        }, kUndoMs);
    }

    get secondsLeft(): number {
        return Math.max(0, Math.ceil((kUndoMs - (Date.now() - this.began_)) / 1000));
    }

    /** False where it is too late. */
    undo(): boolean {
        clearTimeout(this.timer_);
        return !this.over_;
    }
}
