import type { Client } from '../api/client';
import { isAbort, localFileFault } from '../api/problem';
import type { SearchParameters } from '../api/search_parameters';
import type { SearchResult } from '../api/types';

export type UploadState = 'waiting' | 'running' | 'done' | 'failed';

/** A file that was searched with. */
export interface Upload {
    readonly name: string;
    /** Of bytes; null after the page was loaded anew. */
    readonly size: number | null;
    state: UploadState;
    /** The share of it that is on its way to the server. */
    sent?: number;
    /** Under which the server tells its stage. */
    progress?: string;
    /** Where the server keeps it; null where it does not. */
    token: string | null;
    /** What the server said first. */
    answer: { parameters: SearchParameters; result: SearchResult } | null;
    error: unknown;
}

interface Work {
    upload: Upload;
    file: File;
    parameters: SearchParameters;
    /** That of the files that were given together which is done first is shown. */
    together: { shown: boolean };
}

const kStored = 'ossuary.uploads';
/** Later ones push the first out. */
const kMost = 50;

/** The file as it is now: what lies behind a `File` may change or go away later. */
async function copyOf(file: File): Promise<File> {
    try {
        return new File([await file.arrayBuffer()], file.name, { type: file.type });
    } catch {
        throw localFileFault(file.name);
    }
}

function newToken(): string {
    const bytes = [...crypto.getRandomValues(new Uint8Array(16))];
    return bytes.map((byte) => byte.toString(16).padStart(2, '0')).join('');
}

function stored(): Upload[] {
    try {
        const list: unknown = JSON.parse(sessionStorage.getItem(kStored) ?? '[]');
        return (list as { name: string; token: string }[]).map(({ name, token }) => ({
            name: String(name),
            size: null,
            state: 'done',
            token: String(token),
            answer: null,
            error: null,
        }));
    } catch {
        return [];
    }
}

/** The files that this session has searched with, one after the other. */
export class Uploads {
    private readonly client_: Client;
    private readonly listeners_ = new Set<() => void>();
    private readonly bytes_ = new Map<Upload, File>();
    private list_: Upload[] = stored();
    private waiting_: Work[] = [];
    private running_: { upload: Upload; abort: AbortController } | null = null;
    /** Called with the upload of which more is on its way. */
    onSent: (upload: Upload) => void = () => {};
    /** Called with the upload that is to be shown. */
    onDone: (upload: Upload) => void = () => {};

    constructor(client: Client) {
        this.client_ = client;
    }

    get list(): readonly Upload[] {
        return this.list_;
    }

    /** Returns what ends the subscription. */
    subscribe(listener: () => void): () => void {
        this.listeners_.add(listener);
        return () => this.listeners_.delete(listener);
    }

    find(token: string): Upload | undefined {
        return this.list_.find((upload) => upload.token === token);
    }

    /** The last one that the server answered and does not keep. */
    get unkept(): Upload | undefined {
        return this.list_.findLast(({ answer, token }) => answer !== null && token === null);
    }

    take(files: readonly File[], parameters: SearchParameters): void {
        const together = { shown: false };
        for (const file of files) {
            const upload: Upload = {
                name: file.name,
                size: file.size,
                state: 'waiting',
                token: null,
                answer: null,
                error: null,
            };
            this.list_ = [...this.list_, upload].slice(-kMost);
            this.waiting_.push({ upload, file, parameters, together });
        }
        this.changed();
        void this.work();
    }

    /** Sends it again, with other parameters or because the server has forgotten it. */
    async again(
        upload: Upload,
        parameters: SearchParameters,
        signal?: AbortSignal,
    ): Promise<SearchResult | null> {
        const file = this.bytes_.get(upload);
        if (!file) {
            return null;
        }
        const result = await this.client_.search(file, parameters, signal);
        this.keep(upload, parameters, result);
        return result;
    }

    remove(upload: Upload): void {
        this.list_ = this.list_.filter((each) => each !== upload);
        this.waiting_ = this.waiting_.filter((work) => work.upload !== upload);
        this.bytes_.delete(upload);
        if (this.running_?.upload === upload) {
            this.running_.abort.abort();
        }
        this.changed();
    }

    private keep(upload: Upload, parameters: SearchParameters, result: SearchResult): void {
        upload.state = 'done';
        upload.token = result.token ?? null;
        upload.answer = { parameters, result };
        this.changed();
    }

    private async work(): Promise<void> {
        if (this.running_) {
            return;
        }
        for (let next = this.waiting_.shift(); next; next = this.waiting_.shift()) {
            const abort = new AbortController();
            this.running_ = { upload: next.upload, abort };
            await this.send(next, abort.signal);
            this.running_ = null;
        }
    }

    private async send(
        { upload, file, parameters, together }: Work,
        signal: AbortSignal,
    ): Promise<void> {
        upload.state = 'running';
        upload.progress = newToken();
        this.changed();
        try {
            const copy = await copyOf(file);
            this.bytes_.set(upload, copy);
            this.keep(
                upload,
                parameters,
                await this.client_.search(
                    copy,
                    parameters,
                    signal,
                    (share) => {
                        upload.sent = share;
                        this.onSent(upload);
                    },
                    upload.progress,
                ),
            );
            if (!together.shown) {
                together.shown = true;
                this.onDone(upload);
            }
        } catch (error) {
            if (!isAbort(error)) {
                upload.state = 'failed';
                upload.error = error;
                this.changed();
            }
        }
    }

    private changed(): void {
        const kept = this.list_.filter(({ token }) => token !== null);
        try {
            const list = kept.map(({ name, token }) => ({ name, token }));
            sessionStorage.setItem(kStored, JSON.stringify(list));
        } catch {
            // A browser that keeps nothing for pages: the list then lives as long as the page.
        }
        for (const listener of this.listeners_) {
            listener();
        }
    }
}
