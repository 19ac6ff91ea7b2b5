import '../styles/selection.css';
import type { Context } from '../page/context';
import { replace } from '../page/element';
import { selectionBar } from './selection_bar';
import { turntableHover } from './turntable_hover';

export interface CardPlaces {
    /** Where the cards are. */
    cards: HTMLElement;
    /** Where what can be done with chosen ones goes. */
    place: HTMLElement;
}

/** What can be done with cards besides following them: choosing them, and seeing them turn. */
export function cardExtras(context: Context, { cards, place }: CardPlaces): () => void {
    const bar = selectionBar(context);
    const end = turntableHover(cards, context.client);
    replace(place, bar.node);
    return () => {
        bar.dispose();
        end();
    };
}
