import type { NumberFilter } from '../api/client';
import type { Facets } from '../api/types';
import { codePart } from '../page/code_part';
import { element } from '../page/element';
import { problemNotice } from '../page/problem_notice';
import { say } from '../words/say';
import type { NumberFields } from './number_filters';

/** Filters by numbers; their fields are fetched when somebody opens them. */
export class MoreFilters {
    readonly node: HTMLDetailsElement;
    values: NumberFilter = { branches: '', loops: '', extent: '', unit: '' };
    private facets_: Facets | null = null;
    private fields_: NumberFields | null = null;
    private readonly onEdit_: () => void;
    private readonly onOpen_: () => void;

    constructor(onEdit: () => void, onOpen: () => void) {
        this.onEdit_ = onEdit;
        this.onOpen_ = onOpen;
        this.node = element(
            'details',
            { class: 'options more-filters', toggle: () => this.node.open && void this.fetch() },
            element('summary', {}, say('More filters')),
        );
    }

    show(facets: Facets | null, { branches, loops, extent, unit }: NumberFilter): void {
        this.facets_ = facets;
        this.values = { branches, loops, extent, unit };
        // What filters is seen.
        this.node.open ||= branches + loops + extent + unit !== '';
        this.fields_?.show(facets, this.values);
    }

    private async fetch(): Promise<void> {
        this.onOpen_();
        if (this.fields_) {
            return;
        }
        try {
            const { numberFields } = await codePart(() => import('./number_filters'));
            this.fields_ ??= numberFields((name, value) => {
                this.values = { ...this.values, [name]: value };
                this.onEdit_();
            });
            this.fields_.show(this.facets_, this.values);
            this.node.append(this.fields_.node);
        } catch (error) {
            this.node.append(problemNotice(error, { retry: () => location.reload() }));
        }
    }
}
