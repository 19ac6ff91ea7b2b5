import type { Answer, Context } from '../page/context';
import { formatRoute, partsOf } from '../page/routes';
import { comparisonDialog } from './comparison_dialog';
import { nearnessOf } from './nearness';
import { partsDialog } from './parts_dialog';
import { heldModel, overWith, type ResultsRoute, under } from './results_answer';
import type { ViewerDialog } from './viewer_dialog';

/** What lies over the hits: the comparison with one of them, or the query's parts. */
export class OverHits {
    private readonly context_: Context;
    private dialog_: ViewerDialog | null = null;
    /** Which hit was compared last. */
    private hit_: number | null = null;

    constructor(context: Context) {
        this.context_ = context;
    }

    /** As the route says; a hit that is not among the hits leads back to them. */
    show(route: ResultsRoute, answer: Answer | null): void {
        const focused = this.dialog_ ? document.activeElement?.id : '';
        this.close();
        if (!answer || route.over === null) {
            this.focusHit();
            return;
        }
        const dialog = this.make(route, answer, () => this.context_.back(under(route)));
        if (!dialog) {
            this.context_.replace(under(route));
            return;
        }
        this.hit_ = route.over.kind === 'hit' ? route.over.id : null;
        this.dialog_ = dialog;
        document.body.append(dialog.node);
        dialog.open(focused ?? '');
    }

    close(): void {
        const closed = this.dialog_;
        this.dialog_ = null;
        closed?.dispose();
    }

    /** Whoever went from hit to hit comes back at the last one. */
    private focusHit(): void {
        if (this.hit_ !== null) {
            document.querySelector<HTMLElement>(`[data-hit="${this.hit_}"]`)?.focus();
            this.hit_ = null;
        }
    }

    private make(route: ResultsRoute, answer: Answer, onClose: () => void): ViewerDialog | null {
        const { client } = this.context_;
        const { query, hits } = answer.result;
        const { over } = route;
        if (over?.kind === 'parts') {
            const model = heldModel(route);
            this.context_.entitle(`Parts of ${query.name}`);
            return (
                model &&
                partsDialog(
                    {
                        model,
                        query,
                        up: answer.up,
                        posed: over.posed,
                        onPose: (posed) =>
                            this.context_.rewrite(overWith(route, { kind: 'parts', posed })),
                        onClose,
                    },
                    client,
                )
            );
        }
        const place = hits.findIndex(({ id }) => id === over?.id);
        const hit = hits[place];
        if (!hit) {
            return null;
        }
        this.context_.entitle(`${query.name} ↔ ${hit.name}`);
        const stepTo = (at: number): (() => void) | null => {
            const next = hits[at];
            return next
                ? () => this.context_.replace(overWith(route, { kind: 'hit', id: next.id }))
                : null;
        };
        return comparisonDialog(
            {
                query,
                queryMesh: answer.mesh,
                queryUp: answer.up,
                hit,
                nearness: nearnessOf(hit.distance, answer.result),
                partsHref: formatRoute(partsOf({ kind: 'model', id: hit.id }, route.parameters)),
                onPrevious: stepTo(place - 1),
                onNext: stepTo(place + 1),
                onClose,
            },
            client,
        );
    }
}
