import { ApiError } from '../api/problem';
import { type Child, element } from './element';
import { say } from '../words/say';

export interface NoticeOptions {
    /** Asked again on a press of "Try again"; none: no such button. */
    retry: (() => void) | null;
}

const kDefaults: NoticeOptions = { retry: null };

/** Browsers do not ask again for code that they failed to load. */
function wayOn(code: string, retry: () => void): HTMLElement {
    const outdated = code === 'page_part';
    const click = outdated ? () => location.reload() : retry;
    const label = outdated ? say('Load the page anew') : say('Try again');
    return element('button', { type: 'button', class: 'button', click }, label);
}

/** What failed in the words of the problem document, with the code that can be looked up. */
export function problemNotice(error: unknown, options: Partial<NoticeOptions> = {}): HTMLElement {
    const { retry } = { ...kDefaults, ...options };
    const known = error instanceof ApiError;
    const title = known ? error.title : say('Something went wrong in this page');
    const detail = error instanceof Error ? error.message : String(error);
    return element(
        'div',
        { class: 'notice notice-problem', role: 'alert' },
        element(
            'div',
            { class: 'notice-head' },
            element('strong', {}, title),
            known && element('code', { class: 'notice-code' }, error.code),
        ),
        detail !== title && element('p', {}, detail),
        known &&
            error.requestId &&
            element('p', { class: 'fine' }, `${say('Request')} ${error.requestId}`),
        retry && wayOn(known ? error.code : '', retry),
    );
}

/** Nothing went wrong: there is just nothing to show. */
export function emptyNotice(title: string, ...body: Child[]): HTMLElement {
    return element(
        'div',
        { class: 'notice notice-empty' },
        element('strong', {}, title),
        element('p', {}, ...body),
    );
}
