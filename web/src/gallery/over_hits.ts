import { isAbort } from '../api/problem';
import type { Comparison, Hit } from '../api/types';
import type { Answer, Context } from '../page/context';
import { formatRoute, lookAt, partsOf } from '../page/routes';
import { say } from '../words/say';
import { comparisonDialog } from './comparison_dialog';
import { lookDialog } from './look_dialog';
import { nearnessOf } from './nearness';
import { partsDialog } from './parts_dialog';
import { heldModel, overWith, type ResultsRoute, under } from './results_answer';
import type { ViewerDialog } from './viewer_dialog';

/** The second of two models as if it had been found by the first. */
function asHit({ b, ...found }: Comparison): Hit {
    const { min, max } = b.bounds;
    const extent = max.map((high, axis) => high - (min[axis] ?? 0)) as Hit['extent'];
    const { id, name, path, faces, links } = b;
    const { distance, parts, build_difference, pose_difference, matched_nodes, match } = found;
    return {
        rank: 1,
        copies: 0,
        placement: null,
        thumbnail: links.thumbnail,
        ...{ id, name, class: b.class, path, faces, extent },
        ...{ distance, parts, build_difference, pose_difference, matched_nodes, match },
    };
}

/** What lies over the hits: the comparison with one of them, or the query, closer or by its parts. */
export class OverHits {
    private readonly context_: Context;
    private dialog_: ViewerDialog | null = null;
    private running_ = new AbortController();
    /** Which hit was compared last. */
    private hit_: number | null = null;

    constructor(context: Context) {
        this.context_ = context;
    }

    /** As the route says; what is not there leads back to the hits. */
    show(route: ResultsRoute, answer: Answer | null): void {
        const focused = this.dialog_ ? document.activeElement?.id : '';
        this.close();
        const { over } = route;
        if (!answer || over === null) {
            this.focusHit();
            return;
        }
        this.hit_ = over.kind === 'hit' ? over.id : null;
        if (over.kind !== 'hit') {
            this.open(this.query(route, answer), route, focused);
            return;
        }
        const hit = answer.result.hits.find(({ id }) => id === over.id);
        if (hit) {
            this.open(this.comparison(route, answer, hit), route, focused);
        } else {
            void this.openOther(route, answer, over.id);
        }
    }

    close(): void {
        this.running_.abort();
        const closed = this.dialog_;
        this.dialog_ = null;
        closed?.dispose();
    }

    private open(dialog: ViewerDialog | null, route: ResultsRoute, focused = ''): void {
        if (!dialog) {
            this.context_.replace(under(route));
            return;
        }
        this.dialog_ = dialog;
        document.body.append(dialog.node);
        dialog.open(focused);
    }

    /** Any two models of the collection can be compared, whether or not one is among the other's hits. */
    private async openOther(route: ResultsRoute, answer: Answer, id: number): Promise<void> {
        this.running_ = new AbortController();
        const { signal } = this.running_;
        const { query, parameters } = route;
        try {
            const found =
                query.kind === 'model' && query.id !== id
                    ? await this.context_.client.compare(query.id, id, parameters, signal)
                    : null;
            if (!signal.aborted) {
                this.open(found && this.comparison(route, answer, asHit(found)), route);
            }
        } catch (error) {
            if (!isAbort(error)) {
                this.open(null, route);
            }
        }
    }

    /** Whoever went from hit to hit comes back at the last one. */
    private focusHit(): void {
        if (this.hit_ !== null) {
            document.querySelector<HTMLElement>(`[data-hit="${this.hit_}"]`)?.focus();
            this.hit_ = null;
        }
    }

    /** Searches for models that have what a file holds as a part. */
    private find(file: File, route: ResultsRoute): void {
        const { parameters, uploads } = this.context_;
        // How far it is, and what goes wrong, is told outside of the window.
        this.context_.navigate(under(route));
        uploads.take([file], { ...parameters, part: true });
    }

    private query(route: ResultsRoute, answer: Answer): ViewerDialog | null {
        const { query } = answer.result;
        const onClose = (): void => this.context_.back(under(route));
        const onFind = (file: File): void => this.find(file, route);
        if (route.over?.kind === 'look') {
            this.context_.entitle(query.name);
            const { mesh, up } = answer;
            return lookDialog({ query, mesh, up, onFind, onClose });
        }
        const model = heldModel(route);
        const posed = route.over?.kind === 'parts' ? route.over.posed : '';
        this.context_.entitle(say('Parts of {name}', { name: query.name }));
        return (
            model &&
            partsDialog(
                {
                    model,
                    query,
                    up: answer.up,
                    posed,
                    onPose: (turned) =>
                        this.context_.rewrite(overWith(route, { kind: 'parts', posed: turned })),
                    onFind,
                    onClose,
                },
                this.context_.client,
            )
        );
    }

    private comparison(route: ResultsRoute, answer: Answer, hit: Hit): ViewerDialog {
        const { query, hits } = answer.result;
        const place = hits.indexOf(hit);
        this.context_.entitle(`${query.name} ↔ ${hit.name}`);
        const stepTo = (at: number): (() => void) | null => {
            const next = place < 0 ? undefined : hits[at];
            return next
                ? () => this.context_.replace(overWith(route, { kind: 'hit', id: next.id }))
                : null;
        };
        const model = { kind: 'model', id: hit.id } as const;
        return comparisonDialog(
            {
                query,
                queryMesh: answer.mesh,
                queryUp: answer.up,
                hit,
                nearness: nearnessOf(hit.distance, answer.result),
                partsHref: formatRoute(partsOf(model, route.parameters)),
                lookHref: formatRoute(lookAt(model, route.parameters)),
                onPrevious: stepTo(place - 1),
                onNext: stepTo(place + 1),
                onFind: (file) => this.find(file, route),
                onClose: () => this.context_.back(under(route)),
            },
            this.context_.client,
        );
    }
}
