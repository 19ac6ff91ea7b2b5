import type { Page } from 'playwright-core';

const kLong = 'W'.repeat(60);
const kNames = ['name', 'class', 'detail', 'title', 'message', 'path', 'value'];

/** Every name, class and message grown by one long word without a place to break. */
function lengthened(value: unknown): unknown {
    if (Array.isArray(value)) {
        return value.map(lengthened);
    }
    if (typeof value !== 'object' || value === null) {
        return value;
    }
    return Object.fromEntries(
        Object.entries(value).map(([key, entry]) => {
            if (kNames.includes(key) && typeof entry === 'string') {
                return [key, `${entry}_${kLong}`];
            }
            if (key === 'per_class') {
                const rows = Object.entries(entry as object);
                return [key, Object.fromEntries(rows.map(([name, row]) => [name + kLong, row]))];
            }
            if (key === 'classes' && Array.isArray(entry)) {
                return [
                    key,
                    entry.map((name) =>
                        typeof name === 'string' ? name + kLong : lengthened(name),
                    ),
                ];
            }
            if (key === 'warnings') {
                const warning = { code: 'odd', count: 1, message: `Odd: ${kLong}` };
                return [key, [warning]];
            }
            return [key, lengthened(entry)];
        }),
    );
}

/** Lets the server answer questions about its models with names such as people have, only longer. */
export async function answerWithLongWords(page: Page): Promise<void> {
    await page.route(/\/v1\/(models|evaluations|facets)/, async (route) => {
        const response = await route.fetch();
        if (!/json/.test(response.headers()['content-type'] ?? '')) {
            return route.fulfill({ response });
        }
        return route.fulfill({ response, json: lengthened(await response.json()) });
    });
}

/** Answers with a problem document of long words. */
export async function answerWithProblem(page: Page, path: string, code: string): Promise<void> {
    await page.route(path, (route) =>
        route.fulfill({
            status: 404,
            contentType: 'application/problem+json',
            headers: { 'X-Request-Id': kLong },
            body: JSON.stringify({ title: `No ${kLong}`, status: 404, detail: kLong, code }),
        }),
    );
}
