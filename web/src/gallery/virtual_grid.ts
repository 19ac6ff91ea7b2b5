import type { ModelSummary } from '../api/elements';
import { element } from '../page/element';
import { cardsBetween, type GridLayout, gridHeight, gridLayout, placeOf } from './grid_layout';
import type { ModelPages } from './model_pages';

export interface VirtualGridOptions {
    label: string;
    card: (model: ModelSummary) => HTMLElement;
    /** Another model is the first in sight. */
    onMove: (first: number) => void;
}

/** Above and below what is in sight, as a share of the window's height. */
const kBeyond = 0.6;
/** Below the page's head. */
const kHead = 72;
/** Cards that a frame has time for; the others follow in the next ones. */
const kAtOnce = 12;
/** Who scrolls fast does not want what lies on the way. */
const kPauseMs = 60;

const kLeastRows = 2;

interface Card {
    node: HTMLElement;
    model: ModelSummary | undefined;
}

/** A list of any length, of which only the cards in sight are there. */
export class VirtualGrid {
    readonly node: HTMLElement;
    private readonly options_: VirtualGridOptions;
    private readonly cards_ = new Map<number, Card>();
    private readonly undo_ = new AbortController();
    private readonly resized_: ResizeObserver;
    private pages_: ModelPages | null = null;
    private layout_: GridLayout = gridLayout(0);
    private pause_: ReturnType<typeof setTimeout> | undefined;
    private frame_ = 0;
    private first_ = 0;

    constructor(options: VirtualGridOptions) {
        this.options_ = options;
        this.node = element('ul', { class: 'virtual-grid', 'aria-label': options.label });
        addEventListener('scroll', () => this.draw(), {
            passive: true,
            signal: this.undo_.signal,
        });
        // The keyboard is not to come to an end before the next rows are drawn.
        this.node.addEventListener('focusin', (event) => this.placeAround(event.target as Element));
        this.resized_ = new ResizeObserver(() => this.measure());
        this.resized_.observe(this.node);
    }

    /** Shows a list: another one, or what has arrived of the same. */
    take(pages: ModelPages): void {
        if (pages !== this.pages_) {
            this.pages_ = pages;
            this.clear();
        }
        this.measure();
    }

    /** What is in sight and a little more; some always, for whoever does not come by scrolling. */
    private get sight(): { first: number; end: number } {
        const { first, end } = this.between(kBeyond);
        const total = this.pages_?.total ?? 0;
        const least = kLeastRows * this.layout_.columns;
        return end > first ? { first, end } : leastSight(first, least, total);
    }

    /** Lays everything out anew: other models have arrived. */
    refresh(): void {
        this.measure();
    }

    /** Brings a model to the top of the window. */
    scrollTo(index: number): void {
        this.measure();
        const { y } = placeOf(this.layout_, index);
        scrollTo(0, this.node.getBoundingClientRect().top + scrollY + y - kHead);
    }

    dispose(): void {
        this.undo_.abort();
        this.resized_.disconnect();
        clearTimeout(this.pause_);
        cancelAnimationFrame(this.frame_);
    }

    private clear(): void {
        this.node.replaceChildren();
        this.cards_.clear();
    }

    private between(beyond: number): { first: number; end: number } {
        const top = kHead - this.node.getBoundingClientRect().top;
        const more = beyond * innerHeight;
        const total = this.pages_?.total ?? 0;
        return cardsBetween(this.layout_, total, top - more, top + innerHeight + more);
    }

    private measure(): void {
        const layout = gridLayout(this.node.clientWidth);
        if (
            layout.columns !== this.layout_.columns ||
            layout.cardWidth !== this.layout_.cardWidth
        ) {
            this.layout_ = layout;
            this.clear();
        }
        const { style } = this.node;
        style.height = `${gridHeight(layout, this.pages_?.total ?? 0)}px`;
        style.setProperty('--card-width', `${layout.cardWidth}px`);
        style.setProperty('--card-height', `${layout.cardHeight}px`);
        this.show();
    }

    private draw(): void {
        cancelAnimationFrame(this.frame_);
        this.frame_ = requestAnimationFrame(() => this.show());
    }

    private show(): void {
        const { first, end } = this.sight;
        for (const [index, { node }] of this.cards_) {
            // What has the focus stays, or the focus would be lost.
            if ((index < first || index >= end) && !node.contains(document.activeElement)) {
                node.remove();
                this.cards_.delete(index);
            }
        }
        this.fill(first, end);
        this.fetch(first, end);
        const seen = this.between(0).first;
        if (seen !== this.first_) {
            this.first_ = seen;
            this.options_.onMove(seen);
        }
    }

    /** Those in sight before those around them. */
    private fill(first: number, end: number): void {
        const seen = this.between(0);
        const [top, bottom] = [Math.max(first, seen.first), Math.min(end, seen.end)];
        let made = 0;
        const fill = (from: number, to: number): void => {
            for (let index = from; index < to && made < kAtOnce; index++) {
                made += this.place(index) ? 1 : 0;
            }
        };
        fill(top, bottom);
        fill(first, end);
        if (made === kAtOnce) {
            // What is on its way, or has failed, is not asked for again by that.
            cancelAnimationFrame(this.frame_);
            this.frame_ = requestAnimationFrame(() => {
                const sight = this.sight;
                this.fill(sight.first, sight.end);
            });
        }
    }

    private placeAround(target: Element): void {
        const at = Number(target.closest('li')?.getAttribute('aria-posinset')) - 1;
        const more = 2 * kLeastRows * this.layout_.columns;
        const end = Math.min(this.pages_?.total ?? 0, at + more);
        for (let index = Math.max(0, at - more); index < end; index++) {
            this.place(index);
        }
    }

    /** Whether it was not there, or has changed. */
    private place(index: number): boolean {
        const model = this.pages_?.at(index);
        const there = this.cards_.get(index);
        if (there && (there.model === model || !model)) {
            return false;
        }
        const node = model ? this.options_.card(model) : emptyCard();
        node.setAttribute('aria-setsize', String(this.pages_?.total ?? 0));
        node.setAttribute('aria-posinset', String(index + 1));
        const { x, y } = placeOf(this.layout_, index);
        node.style.transform = `translate(${x}px, ${y}px)`;
        if (there) {
            there.node.replaceWith(node);
        } else {
            // In the order of the list, since that is the order of the keyboard.
            const after = [...this.cards_.keys()].filter((each) => each > index);
            const next = after.length > 0 ? this.cards_.get(Math.min(...after)) : undefined;
            this.node.insertBefore(node, next?.node ?? null);
        }
        this.cards_.set(index, { node, model });
        return true;
    }

    private fetch(first: number, end: number): void {
        clearTimeout(this.pause_);
        if (this.pages_?.total) {
            this.pause_ = setTimeout(() => void this.pages_?.want(first, end), kPauseMs);
        }
    }
}

/** The cards next to an empty stretch: the first ones, or the last. */
function leastSight(at: number, least: number, total: number): { first: number; end: number } {
    const first = Math.max(0, Math.min(at, total - least));
    return { first, end: Math.min(total, first + least) };
}

function emptyCard(): HTMLElement {
    return element(
        'li',
        { class: 'card card-loading' },
        element('span', { class: 'thumbnail' }),
        element('span', { class: 'bone' }),
        element('span', { class: 'bone bone-short' }),
    );
}
