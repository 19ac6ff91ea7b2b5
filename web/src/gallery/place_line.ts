import { element } from '../page/element';
import { placeOfModel } from './model_place';

/** Where a model lies, below its name. */
export function placeLine(path: string): HTMLElement | null {
    const place = placeOfModel(path);
    return place === null ? null : element('span', { class: 'fine card-file', title: path }, place);
}
