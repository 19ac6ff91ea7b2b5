import type { JSHandle, Locator, Page } from 'playwright-core';

import { kPatienceMs } from './visitor';

/** Waits until a 3D picture shows what was asked for last. */
export async function untilDrawn(canvas: Locator): Promise<void> {
    await canvas.evaluate(async () => {
        // What the mouse did is handled with the next frame.
        for (let frame = 0; frame < 2; frame++) {
            await new Promise(requestAnimationFrame);
        }
    });
    await canvas
        .and(canvas.page().locator('[data-picture=drawn]'))
        .waitFor({ state: 'attached', timeout: kPatienceMs });
}

/** A screenshot of a 3D picture once it is drawn. */
export async function pictureOf(canvas: Locator): Promise<Buffer> {
    await untilDrawn(canvas);
    return canvas.screenshot();
}

/** The browser has the decoder. */
function pixelsOf(picture: Buffer, page: Page): Promise<JSHandle<ImageData>> {
    return page.evaluateHandle(async (encoded) => {
        const bytes = Uint8Array.from(atob(encoded), (character) => character.charCodeAt(0));
        const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
        const drawing = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
        if (!drawing) {
            throw new Error('this browser draws nothing');
        }
        drawing.drawImage(bitmap, 0, 0);
        return drawing.getImageData(0, 0, bitmap.width, bitmap.height);
    }, picture.toString('base64'));
}

/** How much of a picture is clearly red, 0 to 1. */
export async function redShare(picture: Buffer, page: Page): Promise<number> {
    const pixels = await pixelsOf(picture, page);
    return pixels.evaluate(({ data }) => {
        let red = 0;
        for (let at = 0; at + 2 < data.length; at += 4) {
            const others = Math.max(data[at + 1] ?? 0, data[at + 2] ?? 0);
            red += (data[at] ?? 0) > 2 * others && (data[at] ?? 0) > 60 ? 1 : 0;
        }
        return (4 * red) / data.length;
    });
}

export interface Looks {
    colors: number;
    /** Share of the picture, 0 to 1. */
    drawn: number;
}

/** How many colours a picture has, and how much of it is not the most common one. */
export async function looksOf(picture: Buffer, page: Page): Promise<Looks> {
    const pixels = await pixelsOf(picture, page);
    return pixels.evaluate(({ data, width, height }) => {
        const counts = new Map<number, number>();
        for (let at = 0; at + 2 < data.length; at += 4) {
            // The ground is a gentle gradient: only its coarse colour counts.
            const color =
                (((data[at] ?? 0) >> 5) << 10) |
                (((data[at + 1] ?? 0) >> 5) << 5) |
                ((data[at + 2] ?? 0) >> 5);
            counts.set(color, (counts.get(color) ?? 0) + 1);
        }
        const most = Math.max(...counts.values());
        return { colors: counts.size, drawn: 1 - most / (width * height) };
    });
}

/**
 * How many pixels two pictures of one element differ in. The browser dithers the gradient behind a
 * model, each time it is drawn another way: pixels that are next to equal are equal.
 */
export async function changedPixels(before: Buffer, after: Buffer, page: Page): Promise<number> {
    const pictures = [await pixelsOf(before, page), await pixelsOf(after, page)] as const;
    return page.evaluate(([a, b]) => {
        const most = 3;
        if (a.width !== b.width || a.height !== b.height) {
            return Math.max(a.data.length, b.data.length) / 4;
        }
        let changed = 0;
        for (let at = 0; at < a.data.length; at += 4) {
            const apart = [0, 1, 2, 3].map((channel) =>
                Math.abs((a.data[at + channel] ?? 0) - (b.data[at + channel] ?? 0)),
            );
            changed += Math.max(...apart) > most ? 1 : 0;
        }
        return changed;
    }, pictures);
}
