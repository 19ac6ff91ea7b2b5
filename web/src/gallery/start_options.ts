import { codePart } from '../page/code_part';
import type { Context } from '../page/context';
import { element } from '../page/element';
import { problemNotice } from '../page/problem_notice';
import { say } from '../words/say';
import type { SearchForm } from './search_form';

export interface StartOptions {
    node: HTMLDetailsElement;
    dispose(): void;
}

/** How the next file is searched with; the form is fetched when somebody opens it. */
export function startOptions(context: Context): StartOptions {
    let form: SearchForm | null = null;
    let begun = false;
    let disposed = false;
    const fetch = async (): Promise<void> => {
        begun = true;
        try {
            const { searchForm } = await codePart(() => import('./search_form'));
            if (disposed) {
                return;
            }
            form = searchForm(context.facets, {
                parameters: context.parameters,
                onChange: (parameters) => {
                    context.parameters = parameters;
                },
            });
            node.append(form.node);
        } catch (error) {
            node.append(problemNotice(error, { retry: () => location.reload() }));
        }
    };
    const node = element(
        'details',
        { class: 'options', toggle: () => node.open && !begun && void fetch() },
        element('summary', {}, say('Search options')),
    );
    return {
        node,
        dispose() {
            disposed = true;
            form?.dispose();
        },
    };
}
