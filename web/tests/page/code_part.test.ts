import { expect, it } from 'vitest';

import { codePart } from '../../src/page/code_part';
import { problemNotice } from '../../src/page/problem_notice';

it('hands over what arrives, and names what does not', async () => {
    expect(await codePart(async () => 7)).toBe(7);
    const fault = await codePart(() => Promise.reject(new TypeError('404'))).catch(
        (error) => error,
    );
    expect(fault).toMatchObject({ code: 'page_part' });
    const notice = problemNotice(fault, { retry: () => {} });
    expect(notice.querySelector('button')?.textContent).toBe('Load the page anew');
});
