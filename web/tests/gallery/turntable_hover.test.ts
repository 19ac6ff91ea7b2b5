import { afterEach, expect, it, vi } from 'vitest';

import { modelCard } from '../../src/gallery/model_card';
import { turntableHover } from '../../src/gallery/turntable_hover';
import { Selection } from '../../src/page/selection';
import { clientWith, eventually, kMesh, model } from '../sample';

const kTurned = vi.hoisted(() => ({ shown: [] as unknown[], ended: 0 }));

vi.mock('../../src/viewer/turntable', () => ({
    turntable: (host: HTMLElement) => {
        kTurned.shown.push(host);
        return () => {
            kTurned.ended += 1;
        };
    },
}));

afterEach(() => {
    vi.unstubAllGlobals();
    document.body.replaceChildren();
});

function over(target: Element | null, pointerType = 'mouse'): void {
    target?.dispatchEvent(
        Object.assign(new Event('pointerover', { bubbles: true }), { pointerType }),
    );
}

it('turns one model at a time, that on which a mouse rests', async () => {
    const cards = [7, 8].map((id) => modelCard(model(id), new Selection()));
    document.body.append(...cards);
    const client = clientWith({ mesh: async () => kMesh, model: async (id) => model(id) });
    const end = turntableHover(document.body, client);
    over(cards[0] ?? null, 'touch');
    over(document.body);
    over(cards[0]?.querySelector('.card-name') ?? null);
    await eventually(() => expect(kTurned.shown).toHaveLength(1));
    expect(kTurned.shown[0]).toBe(cards[0]?.querySelector('.thumbnail'));
    over(cards[0]?.querySelector('.thumbnail') ?? null);
    expect(kTurned.ended).toBe(0);
    over(cards[1] ?? null);
    expect(kTurned.ended).toBe(1);
    end();
});

it('leaves alone those who want no motion', async () => {
    vi.stubGlobal('matchMedia', () => ({ matches: true }));
    const card = modelCard(model(7), new Selection());
    document.body.append(card);
    const end = turntableHover(document.body, clientWith({}));
    const before = kTurned.shown.length;
    over(card);
    await new Promise((resolve) => setTimeout(resolve, 400));
    expect(kTurned.shown).toHaveLength(before);
    end();
});
