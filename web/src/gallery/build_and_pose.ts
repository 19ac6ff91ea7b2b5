import type { Hit } from '../api/types';
import { element } from '../page/element';
import { formatDistance } from '../page/format';
import { say } from '../words/say';

/** Where to search from a hit: by its build alone, by its pose alone. */
export interface LikeHit {
    build: string;
    pose: string;
}

/** 1 is as unlike as two models usually are; bars are full at twice that. */
const kFull = 2;

function bar(label: string, difference: number): HTMLElement {
    const share = Math.min(Math.max(difference / kFull, 0), 1);
    const spoken = `${label} ${formatDistance(difference)}`;
    return element(
        'span',
        {
            class: 'difference',
            title: say('{difference} (0: the same, 1: as two models usually are)', {
                difference: spoken,
            }),
        },
        element('span', { class: 'difference-label' }, label),
        element(
            'span',
            { class: 'difference-track', role: 'img', 'aria-label': spoken },
            element('span', { class: 'difference-bar', '--share': share.toFixed(4) }),
        ),
    );
}

/** How far a hit is in build and in pose, whatever the ranking; nothing where that is not known. */
export function differenceBars(hit: Hit): HTMLElement | null {
    if (hit.build_difference === null || hit.pose_difference === null) {
        return null;
    }
    return element(
        'span',
        { class: 'differences' },
        bar(say('Build'), hit.build_difference),
        bar(say('Pose'), hit.pose_difference),
    );
}

/** Searches from a hit by either of the two alone. */
export function likeHitLinks(hit: Hit, { build, pose }: LikeHit): HTMLElement {
    const link = (href: string, text: string): HTMLElement =>
        element(
            'a',
            {
                class: 'like-link',
                href,
                'aria-label': say('{kind} as {name}', { kind: text, name: hit.name }),
            },
            text,
        );
    return element(
        'span',
        { class: 'like-links' },
        link(build, say('Same build')),
        link(pose, say('Same pose')),
    );
}
