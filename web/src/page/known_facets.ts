import type { Client } from '../api/client';
import { kAllModels } from '../api/client';
import type { Facets } from '../api/types';

export type FacetValues = Facets['classes'];
export type FacetName = 'classes' | 'folders' | 'kinds';

/** What the models of the collection are like, with their numbers, asked for once. */
export class KnownFacets {
    private readonly client_: Client;
    private readonly listeners_ = new Set<() => void>();
    private values_: Readonly<Record<FacetName, FacetValues>> = {
        classes: [],
        folders: [],
        kinds: [],
    };
    private asked_ = false;

    constructor(client: Client) {
        this.client_ = client;
    }

    values(facet: FacetName): FacetValues {
        return this.values_[facet];
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
            this.values_ = await this.client_.facets(kAllModels);
        } catch {
            // The next subscriber asks again: without them one can still search in all.
            this.asked_ = false;
            return;
        }
        for (const listener of this.listeners_) {
            listener();
        }
    }
}
