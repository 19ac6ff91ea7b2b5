import '../styles/results.css';
import '../styles/dialog.css';
import { isAbort } from '../api/problem';
import { kSearchDefaults, nextLimit } from '../api/search_parameters';
import type { Answer, Context, Page } from '../page/context';
import { element, replace } from '../page/element';
import { formatPlural } from '../page/format';
import { emptyNotice, problemNotice } from '../page/problem_notice';
import { formatRoute, kHome, type Route, resultsOf, sameQuery } from '../page/routes';
import { hitGrid } from './hit_grid';
import { inOrder, orderField } from './hit_order';
import { OverHits } from './over_hits';
import { QuerySide } from './query_side';
import {
    ask,
    hrefOf,
    likeHit,
    type ResultsRoute,
    sameParameters,
    sameQuestion,
} from './results_answer';
import { saveResults } from './save_results';
import { skeletonCards } from './thumbnail';
import { timingLine } from './timing_line';
import { say } from '../words/say';

function goneNotice(): HTMLElement {
    return emptyNotice(
        say('The uploaded model is gone.'),
        say('The server keeps an upload for a quarter of an hour after it was last asked for.'),
        ' ',
        element('a', { href: formatRoute(kHome) }, say('Choose a model again')),
    );
}

function noHits(): HTMLElement {
    return emptyNotice(say('No hits.'), say('No other model of the collection fits the options.'));
}

class ResultsPage implements Page {
    readonly node: HTMLElement;
    readonly title = say('Results');
    readonly ready: Promise<void>;
    private readonly context_: Context;
    private readonly side_: QuerySide;
    private readonly over_: OverHits;
    private readonly head_ = element('h1', { class: 'results-title' }, say('Searching…'));
    private readonly timing_ = element('div', {});
    private readonly body_ = element('div', { class: 'results-body', 'aria-busy': 'true' });
    private route_: ResultsRoute;
    /** In the server's order, and in that of the page. */
    private found_: Answer | null = null;
    private answer_: Answer | null = null;
    private shown_ = 0;
    private readonly order_ = orderField((order) => {
        const { query, parameters } = this.route_;
        this.context_.replace(resultsOf(query, { ...parameters, order }));
    });
    private running_ = new AbortController();

    constructor(route: ResultsRoute, context: Context) {
        this.route_ = route;
        this.context_ = context;
        this.side_ = new QuerySide(route, context);
        this.over_ = new OverHits(context);
        this.node = element(
            'div',
            { class: 'page results' },
            this.side_.node,
            element(
                'div',
                { class: 'results-main' },
                element(
                    'div',
                    { class: 'results-head' },
                    this.head_,
                    this.order_.node,
                    this.timing_,
                ),
                this.body_,
            ),
        );
        this.ready = this.load();
    }

    update(next: Route): boolean {
        if (next.page !== 'results' || !sameQuery(next.query, this.route_.query)) {
            return false;
        }
        const before = this.route_.parameters;
        const asked = sameParameters(next.parameters, before);
        this.route_ = next;
        this.side_.follow(next);
        if (asked) {
            this.entitle();
            this.over_.show(next, this.answer_);
        } else if (this.found_ && sameQuestion(next.parameters, before)) {
            void this.show(this.found_);
        } else {
            this.over_.close();
            void this.load(
                sameParameters(next.parameters, { ...before, limit: next.parameters.limit }),
            );
        }
        return true;
    }

    dispose(): void {
        this.running_.abort();
        this.over_.close();
        this.side_.dispose();
    }

    /** @param more whether the hits that are shown stay until there are more of them */
    private async load(more = false): Promise<void> {
        this.running_.abort();
        this.running_ = new AbortController();
        const { signal } = this.running_;
        this.found_ = null;
        this.answer_ = null;
        // What the next file is searched with; what was looked for among these hits is not.
        this.context_.parameters = {
            ...this.route_.parameters,
            className: '',
            folder: '',
            kind: '',
            part: false,
            order: kSearchDefaults.order,
        };
        if (!more) {
            replace(this.body_, element('ul', { class: 'grid' }, skeletonCards(12)));
        }
        this.body_.setAttribute('aria-busy', 'true');
        try {
            const found = await ask(this.route_, this.context_, signal);
            if (found) {
                this.renew(found);
                await this.show(found, more ? this.shown_ : 0);
                return;
            }
            this.head_.textContent = say('No query');
            replace(this.body_, goneNotice());
            this.node.classList.add('results-without-query');
        } catch (error) {
            if (!isAbort(error)) {
                this.head_.textContent = say('The search failed');
                const retry = (): void => void this.load();
                replace(this.body_, problemNotice(error, { retry }));
            }
        } finally {
            if (!signal.aborted) {
                this.body_.removeAttribute('aria-busy');
            }
        }
    }

    /** An upload that had to be sent again is kept under another token. */
    private renew({ result: { token } }: Answer): void {
        const { query } = this.route_;
        if (query.kind === 'query' && token && token !== query.token) {
            this.route_ = { ...this.route_, query: { kind: 'query', token } };
            this.context_.rewrite(this.route_);
            this.side_.follow(this.route_);
        }
    }

    /** @param first so many hits are there before anything else happens */
    private async show(found: Answer, first = 0): Promise<void> {
        const { order } = this.route_.parameters;
        const answer = inOrder(found, order);
        this.found_ = found;
        this.answer_ = answer;
        const { query, hits } = answer.result;
        this.order_.show(order, hits.length);
        replace(this.head_, say('Models like'), ' ', element('em', {}, query.name));
        replace(
            this.timing_,
            timingLine(answer.result),
            hits.length > 0 && saveResults(answer.result),
        );
        const grid =
            hits.length > 0
                ? hitGrid(answer.result, {
                      order,
                      hrefOf: (hit) => hrefOf(this.route_, hit),
                      likeOf: (hit) => likeHit(this.route_, hit),
                      selection: this.context_.selection,
                      onMore: this.more(hits.length),
                      first,
                  })
                : null;
        this.shown_ = hits.length;
        replace(this.body_, grid?.node ?? noHits());
        this.context_.announce(
            say('{hits} for {name}', {
                hits: formatPlural(hits.length, 'hit', 'hits'),
                name: query.name,
            }),
        );
        this.side_.show(answer);
        this.entitle();
        this.over_.show(this.route_, answer);
        await grid?.whole;
    }

    /** What shows more hits than are there; null where there are no more. */
    private more(shown: number): (() => void) | null {
        const { query, parameters } = this.route_;
        const limit = nextLimit(parameters.limit);
        return shown < parameters.limit || limit === null
            ? null
            : () => this.context_.replace(resultsOf(query, { ...parameters, limit }));
    }

    private entitle(): void {
        if (this.answer_) {
            this.context_.entitle(`${say('Models like')} ${this.answer_.result.query.name}`);
        }
    }
}

/** What is similar to the query, and on top of it the 3D comparison with one hit. */
export function resultsPage(route: ResultsRoute, context: Context): Page {
    return new ResultsPage(route, context);
}
