import type { Context } from '../page/context';
import { resultsOf } from '../page/routes';
import { comparisonDialog } from './comparison_dialog';
import { partsDialog } from './parts_dialog';
import { type Answer, hrefOf, type ResultsRoute } from './results_answer';
import type { ViewerDialog } from './viewer_dialog';

/** What lies over the hits: the comparison with one of them, or the query's parts. */
export class OverHits {
    private readonly context_: Context;
    private dialog_: ViewerDialog | null = null;

    constructor(context: Context) {
        this.context_ = context;
    }

    /** As the route says; a hit that is not among the hits leads back to them. */
    show(route: ResultsRoute, answer: Answer | null): void {
        this.close();
        if (!answer || route.over === null) {
            return;
        }
        const back = (): void => this.context_.navigate(resultsOf(route.query, route.parameters));
        const dialog = this.make(route, answer, back);
        if (!dialog) {
            back();
            return;
        }
        this.dialog_ = dialog;
        document.body.append(dialog.node);
        dialog.open();
    }

    close(): void {
        const closed = this.dialog_;
        this.dialog_ = null;
        closed?.dispose();
    }

    private make(route: ResultsRoute, answer: Answer, onClose: () => void): ViewerDialog | null {
        const { client } = this.context_;
        const { query, hits } = answer.result;
        const { over } = route;
        if (over?.kind === 'parts') {
            return route.query.kind === 'model'
                ? partsDialog({ id: route.query.id, query, up: answer.up, onClose }, client)
                : null;
        }
        const place = hits.findIndex(({ id }) => id === over?.id);
        const hit = hits[place];
        if (!hit) {
            return null;
        }
        const hrefAt = (at: number): string | null => (hits[at] ? hrefOf(route, hits[at]) : null);
        return comparisonDialog(
            {
                query,
                queryMesh: answer.mesh,
                queryUp: answer.up,
                hit,
                previousHref: hrefAt(place - 1),
                nextHref: hrefAt(place + 1),
                onClose,
            },
            client,
        );
    }
}
