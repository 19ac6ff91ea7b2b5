import type { Client } from '../api/client';
import type { SearchParameters } from '../api/search_parameters';
import type { SearchResult } from '../api/types';
import type { KnownClasses } from './known_classes';
import type { Route } from './routes';

/** The last upload: the server keeps nothing of it, so that it lives as long as the page does. */
export interface Upload {
    file: File;
    parameters: SearchParameters;
    result: SearchResult;
}

/** What every page is given. */
export interface Context {
    client: Client;
    classes: KnownClasses;
    upload: Upload | null;
    navigate(route: Route): void;
    /** Changes the address without leaving a step to go back to, and without a new page. */
    rewrite(route: Route): void;
    /** Said by screen readers. */
    announce(message: string): void;
}

export interface Page {
    readonly node: HTMLElement;
    readonly title: string;
    /** True where the page shows the route without being built anew. */
    update(route: Route): boolean;
    dispose(): void;
}
