/** The last few values by name, each for a while. */
export class Recent<T> {
    private readonly values_ = new Map<string, { value: T; at: number }>();
    private readonly most_: number;
    private readonly milliseconds_: number;
    private readonly now_: () => number;

    constructor(most: number, milliseconds: number, now: () => number = () => Date.now()) {
        this.most_ = most;
        this.milliseconds_ = milliseconds;
        this.now_ = now;
    }

    get(name: string): T | undefined {
        const kept = this.values_.get(name);
        return kept && this.now_() - kept.at <= this.milliseconds_ ? kept.value : undefined;
    }

    /** After what the values depend on has changed. */
    clear(): void {
        this.values_.clear();
    }

    set(name: string, value: T): void {
        this.values_.delete(name);
        this.values_.set(name, { value, at: this.now_() });
        for (const oldest of this.values_.keys()) {
            if (this.values_.size <= this.most_) {
                return;
            }
            this.values_.delete(oldest);
        }
    }
}
