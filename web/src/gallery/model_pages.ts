import type { Client, ModelFilter, ModelOrder } from '../api/client';
import type { ModelSummary } from '../api/elements';
import { isAbort } from '../api/problem';

/** Models a request. */
export const kPageSize = 60;
/** Of them so many stay in memory, those asked for last. */
const kMostPages = 40;

/** A list of models of which those in sight are fetched, page by page. */
export class ModelPages {
    /** None before the first page is there. */
    total: number | null = null;
    private readonly client_: Client;
    private readonly filter_: ModelFilter;
    private readonly sort_: ModelOrder;
    private readonly pages_ = new Map<number, ModelSummary[]>();
    private readonly running_ = new Map<number, AbortController>();
    private readonly onChange_: () => void;
    private readonly onProblem_: (error: unknown) => void;

    constructor(
        client: Client,
        filter: ModelFilter,
        sort: ModelOrder,
        listeners: { onChange: () => void; onProblem: (error: unknown) => void },
    ) {
        this.client_ = client;
        this.filter_ = filter;
        this.sort_ = sort;
        this.onChange_ = listeners.onChange;
        this.onProblem_ = listeners.onProblem;
    }

    at(index: number): ModelSummary | undefined {
        return this.pages_.get(Math.floor(index / kPageSize))?.[index % kPageSize];
    }

    /** Fetches what is missing between two places; what is on its way elsewhere is given up. */
    async want(first: number, end: number): Promise<void> {
        const firstPage = Math.floor(first / kPageSize);
        const lastPage = Math.floor(Math.max(first, end - 1) / kPageSize);
        for (const [page, abort] of this.running_) {
            if (page < firstPage || page > lastPage) {
                abort.abort();
                this.running_.delete(page);
            }
        }
        const loads: Promise<void>[] = [];
        for (let page = firstPage; page <= lastPage; page++) {
            if (!this.pages_.has(page) && !this.running_.has(page)) {
                loads.push(this.load(page));
            }
        }
        await Promise.all(loads);
    }

    dispose(): void {
        for (const abort of this.running_.values()) {
            abort.abort();
        }
    }

    private async load(page: number): Promise<void> {
        const abort = new AbortController();
        this.running_.set(page, abort);
        try {
            const stretch = { sort: this.sort_, offset: page * kPageSize, limit: kPageSize };
            const found = await this.client_.models(this.filter_, stretch, abort.signal);
            this.total = found.total;
            this.keep(page, found.models);
            this.end(page, abort);
            this.onChange_();
        } catch (error) {
            this.end(page, abort);
            if (!isAbort(error)) {
                this.onProblem_(error);
            }
        }
    }

    private end(page: number, abort: AbortController): void {
        if (this.running_.get(page) === abort) {
            this.running_.delete(page);
        }
    }

    private keep(page: number, models: ModelSummary[]): void {
        this.pages_.set(page, models);
        for (const oldest of this.pages_.keys()) {
            if (this.pages_.size <= kMostPages) {
                return;
            }
            this.pages_.delete(oldest);
        }
    }
}
