import type { SearchParameters } from '../api/search_parameters';
import type { Answer, Context } from '../page/context';
import { element } from '../page/element';
import { formatRoute, lookAt, partsOf, resultsOf } from '../page/routes';
import { queryPanel } from './query_panel';
import { heldModel, type ResultsRoute, sameParameters } from './results_answer';
import { type SearchForm, searchForm } from './search_form';
import { takeAway } from './take_away';
import { say } from '../words/say';

/** The column beside the hits: the query and how to search for it. */
export class QuerySide {
    readonly node: HTMLElement;
    private readonly context_: Context;
    private readonly panel_ = queryPanel();
    private route_: ResultsRoute;
    private form_: SearchForm;
    private shown_ = false;

    constructor(route: ResultsRoute, context: Context) {
        this.context_ = context;
        this.route_ = route;
        this.form_ = this.makeForm(route.parameters);
        this.node = element(
            'aside',
            { class: 'results-side' },
            this.panel_.node,
            element(
                'details',
                { class: 'options', open: matchMedia('(min-width: 60rem)').matches },
                element('summary', {}, say('Search options')),
                this.form_.node,
            ),
        );
    }

    /** The query stays the same whatever it is asked for: it is shown once. */
    show({ result, mesh, up }: Answer): void {
        if (!this.shown_) {
            this.shown_ = true;
            const model = heldModel(this.route_);
            const { name } = result.query;
            void this.panel_.show(result.query, {
                mesh,
                up,
                partsHref: model && formatRoute(partsOf(model, this.route_.parameters)),
                lookHref: formatRoute(lookAt(this.route_.query, this.route_.parameters)),
                takeAway: model && takeAway({ model, name, path: '' }, this.context_.client),
            });
        }
    }

    /** By the browser's way back the form is not what brought the change about. */
    follow(route: ResultsRoute): void {
        this.route_ = route;
        const { parameters } = route;
        if (!sameParameters(this.form_.parameters, parameters)) {
            this.form_.dispose();
            const made = this.makeForm(parameters);
            this.form_.node.replaceWith(made.node);
            this.form_ = made;
        }
    }

    dispose(): void {
        this.panel_.dispose();
        this.form_.dispose();
    }

    private makeForm(parameters: SearchParameters): SearchForm {
        return searchForm(this.context_.facets, {
            parameters,
            // Each is a look at the same results: one step back leads away from them.
            onChange: (changed) => this.context_.replace(resultsOf(this.route_.query, changed)),
        });
    }
}
