import type { Page } from 'playwright-core';

/** How wide letters are: those of the machine's fonts, and wider ones than any font has. */
export const kLetterSpacings = ['normal', '0.3em', '1em'] as const;

/** Spaces all letters of the page apart. A sheet made here is no inline style to the page's policy. */
async function spaceLetters(page: Page, spacing: string): Promise<void> {
    await page.evaluate(async (wanted) => {
        const sheet = new CSSStyleSheet();
        sheet.replaceSync(`* { letter-spacing: ${wanted} !important; }`);
        document.adoptedStyleSheets = wanted === 'normal' ? [] : [sheet];
        // Observers of sizes have their say with the frame.
        for (let frame = 0; frame < 2; frame++) {
            await new Promise(requestAnimationFrame);
        }
    }, spacing);
}

/**
 * Whatever is wider than its place at the window's width: the page itself, and every box whose contents
 * stick out or are cut off without a sign. What may be wider: tables that scroll by themselves, lines
 * that end in an ellipsis, fields, and what is there for screen readers alone.
 */
async function tooWide(page: Page): Promise<string[]> {
    return page.evaluate(() => {
        const found: string[] = [];
        const allowed = 'input, select, datalist, .table-scroll, .visually-hidden, .progress-bar';
        for (const node of document.querySelectorAll('html, body, body *')) {
            const { display, textOverflow } = getComputedStyle(node);
            const over = node.scrollWidth - node.clientWidth;
            if (
                over > 1 &&
                node.getClientRects().length > 0 &&
                display !== 'inline' &&
                textOverflow !== 'ellipsis' &&
                !(node instanceof SVGElement) &&
                !node.matches(allowed)
            ) {
                const name = [node.tagName.toLowerCase(), ...node.classList].join('.');
                found.push(`${name} is ${over} px too narrow for what is in it`);
            }
        }
        return found;
    });
}

/** The faults at every width of letters, each with the width that shows it. */
export async function layoutFaults(page: Page): Promise<string[]> {
    const found: string[] = [];
    for (const spacing of kLetterSpacings) {
        await spaceLetters(page, spacing);
        found.push(...(await tooWide(page)).map((fault) => `letters + ${spacing}: ${fault}`));
    }
    await spaceLetters(page, 'normal');
    return found;
}
