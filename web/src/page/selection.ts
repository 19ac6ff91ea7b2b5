/** What of a chosen model is needed to do something with it. */
export interface Chosen {
    id: number;
    name: string;
    /** Below the folder that was indexed; empty: it has none. */
    path: string;
    class: string | null;
}

const kStored = 'ossuary.selection';
/** More are a list rather than a choice. */
export const kMostChosen = 1000;

function stored(): Chosen[] {
    try {
        const list: unknown = JSON.parse(sessionStorage.getItem(kStored) ?? '[]');
        return (list as Chosen[]).filter(({ id }) => Number.isSafeInteger(id));
    } catch {
        return [];
    }
}

/** The models that were ticked, in the order of the ticks; they stay for the session. */
export class Selection {
    private readonly chosen_ = new Map<number, Chosen>(stored().map((each) => [each.id, each]));
    private readonly listeners_ = new Set<() => void>();

    get list(): readonly Chosen[] {
        return [...this.chosen_.values()];
    }

    has(id: number): boolean {
        return this.chosen_.has(id);
    }

    set(model: Chosen, on: boolean): void {
        if (on && this.chosen_.size < kMostChosen) {
            this.chosen_.set(model.id, model);
        } else {
            this.chosen_.delete(model.id);
        }
        this.changed();
    }

    clear(): void {
        this.chosen_.clear();
        this.changed();
    }

    /** Returns what ends the subscription. */
    subscribe(listener: () => void): () => void {
        this.listeners_.add(listener);
        return () => this.listeners_.delete(listener);
    }

    private changed(): void {
        try {
            sessionStorage.setItem(kStored, JSON.stringify(this.list));
        } catch {
            // Then it lives as long as the page.
        }
        for (const listener of this.listeners_) {
            listener();
        }
    }
}
