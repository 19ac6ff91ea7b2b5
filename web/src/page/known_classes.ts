import type { Client } from '../api/client';
import { kAllModels } from '../api/client';
import type { Facets } from '../api/types';

export type FacetValues = Facets['classes'];

/** The classes of the collection with their numbers of models, asked for once. */
export class KnownClasses {
    private readonly client_: Client;
    private readonly listeners_ = new Set<() => void>();
    private values_: FacetValues = [];
    private asked_ = false;

    constructor(client: Client) {
        this.client_ = client;
    }

    get values(): FacetValues {
        return this.values_;
    }

    /** Returns what ends the subscription. */
    subscribe(listener: () => void): () => void {
        this.listeners_.add(listener);
        if (!this.asked_) {
            this.asked_ = true;
            void this.ask();
        }
        return () => this.listeners_.delete(listener);
    }

    private async ask(): Promise<void> {
        try {
            this.values_ = (await this.client_.facets(kAllModels)).classes;
        } catch {
            // The next subscriber asks again: without classes one can still search in all.
            this.asked_ = false;
            return;
        }
        for (const listener of this.listeners_) {
            listener();
        }
    }
}
