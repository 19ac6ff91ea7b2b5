import { ApiError } from '../api/problem';
import { say } from '../words/say';

/** Code that is fetched only when it is needed. Errors: page_part. */
export async function codePart<T>(load: () => Promise<T>): Promise<T> {
    try {
        return await load();
    } catch {
        throw new ApiError({
            title: say('A part of this page did not arrive'),
            status: 0,
            detail: say(
                'The server cannot be reached, or has been updated since the page was loaded.',
            ),
            code: 'page_part',
        });
    }
}
