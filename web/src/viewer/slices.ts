/** So long at most that a hand notices nothing. */
const kSliceMs = 12;

/** After what waits for the page's thread, input above all. */
function breath(): Promise<void> {
    return new Promise((resolve) => setTimeout(resolve, 0));
}

/** Work in one go. */
export function atOnce<T>(work: Generator<void, T>): T {
    let step = work.next();
    while (!step.done) {
        step = work.next();
    }
    return step.value;
}

/** Long work, a little at a time: it may be interrupted wherever it yields. Null: it was given up. */
export async function inSlices<T>(
    work: Generator<void, T>,
    isWanted: () => boolean = () => true,
): Promise<T | null> {
    for (;;) {
        const until = performance.now() + kSliceMs;
        let step = work.next();
        while (!step.done && performance.now() < until) {
            step = work.next();
        }
        if (step.done) {
            return step.value;
        }
        await breath();
        if (!isWanted()) {
            // Gives back what it holds.
            work.return(undefined as never);
            return null;
        }
    }
}
