import type { SearchParameters } from '../api/search_parameters';
import type { Context } from '../page/context';
import { element } from '../page/element';
import { formatRoute, partsOf, type QuerySource, resultsOf } from '../page/routes';
import { queryPanel } from './query_panel';
import { type Answer, type ResultsRoute, sameParameters } from './results_answer';
import { type SearchForm, searchForm } from './search_form';

/** The column beside the hits: the query and how to search for it. */
export class QuerySide {
    readonly node: HTMLElement;
    private readonly context_: Context;
    private readonly panel_ = queryPanel();
    private readonly query_: QuerySource;
    private form_: SearchForm;
    private shown_ = false;

    constructor({ query, parameters }: ResultsRoute, context: Context) {
        this.context_ = context;
        this.query_ = query;
        this.form_ = this.makeForm(parameters);
        this.node = element(
            'aside',
            { class: 'results-side' },
            this.panel_.node,
            element(
                'details',
                { class: 'options', open: matchMedia('(min-width: 60rem)').matches },
                element('summary', {}, 'Search options'),
                this.form_.node,
            ),
        );
    }

    /** The query stays the same whatever it is asked for: it is shown once. */
    show({ result, mesh, up }: Answer, parameters: SearchParameters): void {
        if (!this.shown_) {
            this.shown_ = true;
            const partsHref =
                this.query_.kind === 'model'
                    ? formatRoute(partsOf(this.query_.id, parameters))
                    : null;
            void this.panel_.show(result.query, { mesh, up, partsHref });
        }
    }

    /** By the browser's way back the form is not what brought the change about. */
    follow(parameters: SearchParameters): void {
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
        return searchForm(this.context_.classes, {
            parameters,
            onChange: (changed) => this.context_.navigate(resultsOf(this.query_, changed)),
        });
    }
}
