import type { Client } from '../api/client';
import { isAbort } from '../api/problem';
import { kSearchDefaults } from '../api/search_parameters';
import type { Hit, QueryMetrics, Ranker } from '../api/types';
import { element, replace } from '../page/element';
import { problemNotice } from '../page/problem_notice';
import { formatRoute, resultsOf } from '../page/routes';
import { say } from '../words/say';

export interface ConfusedPair {
    query: QueryMetrics;
    nearest: Hit;
}

/** More are a list to read rather than models to look at. */
const kMostLookups = 60;

/** Models of one class whose nearest neighbour, as a search finds it now, is of another one. */
export async function confusedModels(
    client: Client,
    ranker: Ranker,
    { from, to }: { from: string; to: string },
    signal: AbortSignal,
): Promise<ConfusedPair[]> {
    const queries = await client.evaluatedQueries(ranker, signal);
    const failed = queries
        .filter((query) => query.class === from && query.nearest_neighbor === 0)
        .slice(0, kMostLookups);
    const parameters = { ...kSearchDefaults, ranker, limit: 1, fold: false };
    const nearest = await Promise.all(
        failed.map(({ model }) => client.similar({ kind: 'model', id: model }, parameters, signal)),
    );
    return failed.flatMap((query, at) => {
        const hit = nearest[at]?.hits[0];
        return hit?.class === to ? [{ query, nearest: hit }] : [];
    });
}

function pairItem({ query, nearest }: ConfusedPair, ranker: Ranker): HTMLElement {
    const href = formatRoute(
        resultsOf(
            { kind: 'model', id: query.model },
            { ...kSearchDefaults, ranker },
            { kind: 'hit', id: nearest.id },
        ),
    );
    return element('li', {}, element('a', { href }, `${query.name} ↔ ${nearest.name}`));
}

/** The models behind a cell of the confusion matrix, each with a way to the comparison. */
export class ConfusedModels {
    readonly node = element('div', { class: 'confused', 'aria-live': 'polite' });
    private readonly client_: Client;
    private readonly ranker_: Ranker;
    private running_ = new AbortController();

    constructor(client: Client, ranker: Ranker) {
        this.client_ = client;
        this.ranker_ = ranker;
    }

    async show(from: string, to: string): Promise<void> {
        this.running_.abort();
        this.running_ = new AbortController();
        const { signal } = this.running_;
        const title = element('h3', {}, say('{from} taken for {to}', { from, to }));
        replace(this.node, title, element('p', { class: 'fine working' }, say('Loading…')));
        try {
            const pairs = await confusedModels(this.client_, this.ranker_, { from, to }, signal);
            replace(
                this.node,
                title,
                pairs.length > 0
                    ? element(
                          'ul',
                          {},
                          pairs.map((pair) => pairItem(pair, this.ranker_)),
                      )
                    : element('p', { class: 'fine' }, say('A search finds none of them now.')),
            );
        } catch (error) {
            if (!isAbort(error)) {
                const retry = (): void => void this.show(from, to);
                replace(this.node, title, problemNotice(error, { retry }));
            }
        }
    }

    dispose(): void {
        this.running_.abort();
    }
}
