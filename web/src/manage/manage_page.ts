import '../styles/manage.css';
import { type Administration, createAdministration } from '../api/administration';
import { ApiError, isAbort } from '../api/problem';
import { adminKey, keepAdminKey } from '../page/admin_key';
import type { Context, Page } from '../page/context';
import { element, replace } from '../page/element';
import { formatPlural } from '../page/format';
import { problemNotice } from '../page/problem_notice';
import { formatRoute, kHome } from '../page/routes';
import { say } from '../words/say';
import { AddedModels } from './added_models';
import { failureTable } from './failure_table';
import { JobList } from './job_list';
import { PendingRemoval } from './pending_removal';

function panel(id: string, title: string, ...content: (Node | false | null)[]): HTMLElement {
    return element(
        'section',
        { class: 'panel', 'aria-labelledby': id },
        element('h2', { id }, title),
        ...content,
    );
}

/** Keeps the collection: for whoever has the administrator's key. */
class ManagePage implements Page {
    readonly node = element('div', { class: 'page manage' });
    readonly title = say('Manage');
    readonly ready: Promise<void>;
    private readonly context_: Context;
    private readonly running_ = new AbortController();
    private readonly body_ = element('div', { class: 'manage-body' });
    private readonly failures_ = element('div', {});
    private readonly chosen_ = element('div', { class: 'manage-chosen' });
    private readonly pending_ = element('div', { class: 'manage-pending', 'aria-live': 'polite' });
    private readonly classes_ = element('datalist', { id: 'manage-classes' });
    private readonly added_: AddedModels;
    private readonly jobs_ = new JobList(() => this.administration_);
    private readonly unsubscribe_: (() => void)[] = [];
    private administration_: Administration;
    private tick_: ReturnType<typeof setInterval> | undefined;

    constructor(context: Context, make: (key: string) => Administration) {
        this.context_ = context;
        this.make_ = make;
        this.administration_ = make(adminKey());
        this.added_ = new AddedModels(
            () => this.administration_,
            () => {
                context.answers.clear();
                void this.jobs_.look();
            },
        );
        replace(
            this.node,
            element('h1', {}, say('Manage')),
            element(
                'p',
                { class: 'lede' },
                say('Add, remove and sort models, with the administrator’s key.'),
            ),
            this.pending_,
            this.body_,
        );
        this.ready = this.enter();
    }

    private readonly make_: (key: string) => Administration;

    update(route: { page: string }): boolean {
        return route.page === 'manage';
    }

    dispose(): void {
        this.running_.abort();
        this.added_.dispose();
        this.jobs_.dispose();
        clearInterval(this.tick_);
        for (const end of this.unsubscribe_) {
            end();
        }
    }

    /** With the key of this session, if there is one that the server takes. */
    private async enter(): Promise<void> {
        if (adminKey() === '') {
            this.askForKey(null);
            return;
        }
        try {
            const failures = await this.administration_.failures(this.running_.signal);
            this.show();
            replace(this.failures_, failureTable(failures));
            void this.jobs_.look();
        } catch (error) {
            if (isAbort(error)) {
                return;
            }
            if (error instanceof ApiError && error.code === 'admin_key_wrong') {
                keepAdminKey('');
            }
            this.askForKey(error);
        }
    }

    private askForKey(error: unknown): void {
        const key = element('input', {
            type: 'password',
            class: 'input',
            name: 'key',
            autocomplete: 'off',
            required: true,
        });
        const form = element(
            'form',
            { class: 'manage-form' },
            element(
                'label',
                { class: 'field' },
                element('span', { class: 'field-label' }, say('Administrator’s key')),
                key,
            ),
            element('button', { class: 'button button-primary' }, say('Go on')),
            element('p', { class: 'fine' }, say('It is kept in this tab until it is closed.')),
        );
        form.addEventListener('submit', (event) => {
            event.preventDefault();
            keepAdminKey(key.value.trim());
            this.administration_ = this.make_(key.value.trim());
            void this.enter();
        });
        replace(this.body_, error !== null && problemNotice(error), form);
    }

    private show(): void {
        const { facets, selection } = this.context_;
        const showClasses = (): void =>
            replace(
                this.classes_,
                facets
                    .values('classes')
                    .flatMap(({ value }) => (value === null ? [] : element('option', { value }))),
            );
        this.unsubscribe_.push(
            facets.subscribe(showClasses),
            selection.subscribe(() => this.showChosen()),
        );
        showClasses();
        this.showChosen();
        const leave = (): void => {
            keepAdminKey('');
            this.askForKey(null);
        };
        replace(
            this.body_,
            this.classes_,
            panel('add-title', say('Add models'), this.addForm(), this.added_.node),
            panel('jobs-title', say('What was added'), this.jobs_.node),
            panel('chosen-title', say('Sort or remove'), this.chosen_),
            panel('failures-title', say('Files that could not be indexed'), this.failures_),
            element(
                'button',
                { type: 'button', class: 'button', click: leave },
                say('Forget the key'),
            ),
        );
    }

    private classField(): { node: HTMLElement; input: HTMLInputElement } {
        const input = element('input', {
            class: 'input',
            list: 'manage-classes',
            maxlength: 256,
            autocomplete: 'off',
        });
        const label = element('span', { class: 'field-label' }, say('Class'));
        return { node: element('label', { class: 'field' }, label, input), input };
    }

    private addForm(): HTMLElement {
        const { node, input: className } = this.classField();
        const picked = (folder: boolean): HTMLElement => {
            const files = element('input', {
                type: 'file',
                multiple: true,
                class: 'input',
                webkitdirectory: folder,
            });
            files.addEventListener('change', () => {
                this.added_.add([...(files.files ?? [])], className.value.trim());
                files.value = '';
            });
            const label = folder ? say('A folder') : say('Files');
            return element(
                'label',
                { class: 'field' },
                element('span', { class: 'field-label' }, label),
                files,
            );
        };
        return element('div', { class: 'manage-form' }, node, picked(false), picked(true));
    }

    private showChosen(): void {
        const { selection } = this.context_;
        const count = selection.list.length;
        if (count === 0) {
            const way = element('a', { href: formatRoute(kHome) }, say('To the collection'));
            replace(this.chosen_, say('Tick models in the collection or among hits.'), ' ', way);
            return;
        }
        const { node, input } = this.classField();
        const form = element(
            'form',
            { class: 'manage-form' },
            element('p', {}, formatPlural(count, 'model', 'models')),
            node,
            element('button', { class: 'button' }, say('Set the class')),
            element(
                'button',
                { type: 'button', class: 'button button-danger', click: () => this.remove() },
                say('Remove them'),
            ),
        );
        form.addEventListener('submit', (event) => {
            event.preventDefault();
            void this.classify(input.value.trim());
        });
        replace(this.chosen_, form);
    }

    private async classify(className: string): Promise<void> {
        const { selection, answers } = this.context_;
        const models = selection.list;
        try {
            for (const [at, model] of models.entries()) {
                replace(
                    this.pending_,
                    say('{done} of {all} done', { done: at, all: models.length }),
                );
                await this.administration_.classify(model.id, className);
                selection.set({ ...model, class: className || null }, true);
            }
            replace(
                this.pending_,
                say('{done} of {all} done', { done: models.length, all: models.length }),
            );
        } catch (error) {
            replace(this.pending_, problemNotice(error));
        }
        answers.clear();
    }

    /** Ten seconds pass before anything is gone. */
    private remove(): void {
        const { selection, answers } = this.context_;
        const models = selection.list;
        selection.clear();
        clearInterval(this.tick_);
        const left = element('span', { class: 'number' });
        const undo = (): void => {
            if (removal.undo()) {
                clearInterval(this.tick_);
                for (const model of models) {
                    selection.set(model, true);
                }
                replace(this.pending_, say('Nothing was removed.'));
            }
        };
        const removal = new PendingRemoval(models, this.administration_, (error, removed) => {
            clearInterval(this.tick_);
            answers.clear();
            const text = say('{models} removed', {
                models: formatPlural(removed.length, 'model', 'models'),
            });
            replace(this.pending_, error === null ? text : [text, problemNotice(error)]);
        });
        const tick = (): void => {
            left.textContent = `${removal.secondsLeft} s`;
        };
        tick();
        this.tick_ = setInterval(tick, 250);
        replace(
            this.pending_,
            say('{models} will be removed', {
                models: formatPlural(models.length, 'model', 'models'),
            }),
            ' ',
            left,
            ' ',
            element('button', { type: 'button', class: 'button', click: undo }, say('Undo')),
        );
    }
}

export function managePage(
    context: Context,
    make: (key: string) => Administration = createAdministration,
): Page {
    return new ManagePage(context, make);
}
