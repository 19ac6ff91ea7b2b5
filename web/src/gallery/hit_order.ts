import { type HitOrder, kHitOrders } from '../api/search_parameters';
import type { Hit } from '../api/types';
import type { Answer } from '../page/context';
import { element } from '../page/element';
import { say, spokenLanguage, type Text } from '../words/say';

const kNames: Record<HitOrder, Text> = {
    distance: 'Nearest first',
    name: 'Name',
    faces: 'Most faces',
    size: 'Largest first',
};

const largest = ({ extent }: Hit): number => Math.max(...extent);

function comparison(order: HitOrder): (a: Hit, b: Hit) => number {
    if (order === 'name') {
        const { compare } = new Intl.Collator(spokenLanguage(), { numeric: true });
        return (a, b) => compare(a.name, b.name);
    }
    return order === 'faces' ? (a, b) => b.faces - a.faces : (a, b) => largest(b) - largest(a);
}

/** The same hits in another order; those that are equal in it the nearest first. */
export function inOrder(answer: Answer, order: HitOrder): Answer {
    if (order === 'distance') {
        return answer;
    }
    const { result } = answer;
    const hits = result.hits.toSorted((a, b) => comparison(order)(a, b) || a.rank - b.rank);
    return { ...answer, result: { ...result, hits } };
}

/** What hits in that order are called. */
export function orderLabel(order: HitOrder): string {
    return order === 'distance'
        ? say('Hits, most similar first')
        : say('Hits by: {order}', { order: say(kNames[order]) });
}

export interface OrderField {
    node: HTMLElement;
    show(order: HitOrder, hits: number): void;
}

/** By what the hits are sorted. */
export function orderField(onChange: (order: HitOrder) => void): OrderField {
    const select = element(
        'select',
        { class: 'input', name: 'order' },
        kHitOrders.map((order) => element('option', { value: order }, say(kNames[order]))),
    );
    select.addEventListener('change', () => {
        const order = kHitOrders.find((each) => each === select.value);
        if (order) {
            onChange(order);
        }
    });
    const node = element(
        'label',
        { class: 'field hit-order', hidden: true },
        element('span', { class: 'field-label' }, say('Order')),
        select,
    );
    return {
        node,
        show(order, hits) {
            select.value = order;
            node.hidden = hits < 2;
        },
    };
}
