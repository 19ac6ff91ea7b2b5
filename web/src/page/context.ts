import type { Client } from '../api/client';
import type { PreviewMesh, UpAxis } from '../api/elements';
import type { SearchParameters } from '../api/search_parameters';
import type { SearchResult } from '../api/types';
import type { KnownFacets } from './known_facets';
import type { Recent } from './recent';
import type { Route } from './routes';
import type { Selection } from './selection';
import type { Uploads } from './uploads';

/** What the server says of a query, and how to draw it. */
export interface Answer {
    result: SearchResult;
    mesh: PreviewMesh | null;
    up: UpAxis;
}

/** What every page is given. */
export interface Context {
    client: Client;
    facets: KnownFacets;
    uploads: Uploads;
    /** The models that are ticked. */
    selection: Selection;
    /** By the address of their results: for the way back. */
    answers: Recent<Answer>;
    /** As a search was asked for last: what the next upload is searched with. */
    parameters: SearchParameters;
    /** A step that the browser's way back undoes. */
    navigate(route: Route): void;
    /** The same in place of the last one. */
    replace(route: Route): void;
    /** Goes back if a page of results led here, else to `fallback` in place of this. */
    back(fallback: Route): void;
    /** Changes the address without leaving a step to go back to, and without a new page. */
    rewrite(route: Route): void;
    /** Says in the window's title what is shown. */
    entitle(title: string): void;
    /** Said by screen readers. */
    announce(message: string): void;
}

export interface Page {
    readonly node: HTMLElement;
    readonly title: string;
    /** Once there is something to scroll to. */
    readonly ready: Promise<void>;
    /** True where the page shows the route without being built anew. */
    update(route: Route): boolean;
    dispose(): void;
}
