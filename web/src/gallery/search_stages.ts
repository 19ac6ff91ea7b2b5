import type { Client } from '../api/client';
import { formatName } from '../page/format';
import { say, sayName } from '../words/say';
import { kPipeline } from './pipeline';

const kBetweenMs = 200;

/** A stage that the server has named, as one reads it. */
export function nameOfStage(stage: string): string {
    if (stage === 'wait') {
        return say('waits until other searches are done');
    }
    const step = kPipeline.indexOf(stage) + 1;
    const name = sayName(formatName(stage));
    return step === 0
        ? name
        : `${name} (${say('step {step} of {all}', { step, all: kPipeline.length })})`;
}

/**
 * Asks for the stage of a search until `stop` is requested; `onStage` is told each new one. Some stages run
 * beside each other: what is told goes forward alone.
 */
export async function followStages(
    client: Pick<Client, 'progress'>,
    token: string,
    onStage: (stage: string) => void,
    stop: AbortSignal,
): Promise<void> {
    let furthest = -2;
    while (!stop.aborted) {
        try {
            const { stage } = await client.progress(token, stop);
            const place = stage === null ? -3 : kPipeline.indexOf(stage);
            if (stage !== null && place > furthest && !stop.aborted) {
                furthest = place;
                onStage(stage);
            }
        } catch {
            // A help, not more: the search itself says what is wrong.
        }
        await new Promise((resolve) => setTimeout(resolve, kBetweenMs));
    }
}
