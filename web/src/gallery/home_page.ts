import type { Context, Page } from '../page/context';
import { element } from '../page/element';
import type { HomeRoute } from '../page/routes';
import { collection } from './collection';
import { dropZone } from './drop_zone';
import { startOptions } from './start_options';
import { say } from '../words/say';

/** Where one starts: drop a model, or pick one of the collection. */
export function homePage(route: HomeRoute, context: Context): Page {
    const options = startOptions(context);
    const models = collection(route, context);
    return {
        node: element(
            'div',
            { class: 'page home' },
            element(
                'section',
                { class: 'hero' },
                element(
                    'div',
                    { class: 'hero-text' },
                    element('h1', {}, say('Find models that are built like this one.')),
                    element(
                        'p',
                        { class: 'lede' },
                        say(
                            'Each model is thinned to its skeleton. Two models are alike when their skeletons can be laid over each other, branch by branch.',
                        ),
                    ),
                    options.node,
                ),
                element(
                    'div',
                    { class: 'hero-drop' },
                    dropZone((files) => context.uploads.take(files, context.parameters)),
                ),
            ),
            models.node,
        ),
        title: say('Search'),
        ready: models.ready,
        update(next) {
            if (next.page !== 'home') {
                return false;
            }
            models.show(next);
            return true;
        },
        dispose() {
            options.dispose();
            models.dispose();
        },
    };
}
