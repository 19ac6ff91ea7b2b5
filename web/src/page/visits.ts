/** Where a page was left. */
export interface Place {
    y: number;
    /** The address of the link that had the focus; null: none had. */
    link: string | null;
}

interface Mark {
    visit: number;
    /** The address that led here; null: none of this page. */
    from: string | null;
}

function markOf(state: unknown): Mark | null {
    const mark = (state as { ossuary?: Mark } | null)?.ossuary;
    return mark && Number.isInteger(mark.visit) ? mark : null;
}

/**
 * The browser's history, with what it does not keep: which step each address is, what led to it and
 * where it was left.
 */
export class Visits {
    private readonly places_ = new Map<number, Place>();
    private last_ = 0;
    private here_: Mark;

    constructor() {
        history.scrollRestoration = 'manual';
        this.here_ = this.arrive(null);
    }

    get from(): string | null {
        return this.here_.from;
    }

    /** Where this step was left when the way led on from it. */
    get place(): Place | undefined {
        return this.places_.get(this.here_.visit);
    }

    /** Before what is shown goes. */
    leave(place: Place): void {
        this.places_.set(this.here_.visit, place);
    }

    /** After the browser has gone to another address, from `from` on. */
    follow(from: string): void {
        this.here_ = this.arrive(from);
    }

    push(address: string, from: string): void {
        history.pushState(null, '', address);
        this.follow(from);
    }

    replace(address: string): void {
        history.replaceState(history.state, '', address);
    }

    private arrive(from: string | null): Mark {
        const known = markOf(history.state);
        // After the page was loaded anew steps have numbers that it does not know yet.
        this.last_ = Math.max(this.last_, known?.visit ?? 0);
        if (known) {
            return known;
        }
        this.last_ += 1;
        const mark: Mark = { visit: this.last_, from };
        history.replaceState({ ossuary: mark }, '');
        return mark;
    }
}
