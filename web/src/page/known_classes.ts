/** The classes seen so far, which the class filters suggest. */
export class KnownClasses {
    private readonly names_ = new Set<string>();
    private readonly listeners_ = new Set<() => void>();

    get names(): string[] {
        return [...this.names_].sort((a, b) => a.localeCompare(b, 'en'));
    }

    add(names: Iterable<string | null>): void {
        const before = this.names_.size;
        for (const name of names) {
            if (name) {
                this.names_.add(name);
            }
        }
        if (this.names_.size > before) {
            for (const listener of this.listeners_) {
                listener();
            }
        }
    }

    /** Returns what ends the subscription. */
    subscribe(listener: () => void): () => void {
        this.listeners_.add(listener);
        return () => this.listeners_.delete(listener);
    }
}
