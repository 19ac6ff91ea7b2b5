import { element, svg } from './element';
import { formatRoute, kHome, type Route } from './routes';
import { keepLanguage, kLanguages, say, spokenLanguage } from '../words/say';

export interface Header {
    node: HTMLElement;
    /** Marks the link of the page that is shown. */
    show(route: Route): void;
}

/** A skeleton with its joints: the mark of the project, drawn like favicon.svg. */
export function logo(): SVGElement {
    return svg(
        'svg',
        { class: 'logo', viewBox: '0 0 32 32', 'aria-hidden': 'true', focusable: 'false' },
        svg('path', {
            class: 'logo-line',
            d: 'M5 26 C6 19 8 15 12.5 14 S20 14.5 22.5 12 M12.5 14 C14 19 14.5 22 14 27 M22.5 12 C24 17 24.5 21 26 26 M22.5 12 C24 8.5 25 7 27 5',
        }),
        ...[
            [12.5, 14, 3.1],
            [22.5, 12, 3.1],
            [27, 5, 2.1],
            [5, 26, 2.1],
            [14, 27, 2.1],
            [26, 26, 2.1],
        ].map(([cx, cy, r]) => svg('circle', { class: 'logo-joint', cx, cy, r })),
    );
}

/** Takes the page's words from another table; the page is built anew. */
function languageSwitch(): HTMLElement {
    const select = element(
        'select',
        { class: 'language', 'aria-label': say('Language') },
        kLanguages.map((each) =>
            element('option', { value: each, lang: each }, each.toUpperCase()),
        ),
    );
    select.value = spokenLanguage();
    select.addEventListener('change', () => {
        const chosen = kLanguages.find((each) => each === select.value);
        if (chosen) {
            keepLanguage(chosen);
            location.reload();
        }
    });
    return select;
}

/** @param actions what can be done on every page */
export function header(actions: HTMLElement): Header {
    const links = [
        { page: 'home', label: say('Search'), href: formatRoute(kHome) },
        { page: 'reports', label: say('Reports'), href: formatRoute({ page: 'reports' }) },
        { page: 'manage', label: say('Manage'), href: formatRoute({ page: 'manage' }) },
    ].map(({ page, label, href }) => ({ page, node: element('a', { href }, label) }));
    const node = element(
        'header',
        { class: 'header' },
        element(
            'a',
            { class: 'brand', href: formatRoute(kHome), 'aria-label': say('Ossuary, start page') },
            logo(),
            element('span', {}, 'Ossuary'),
        ),
        element(
            'div',
            { class: 'header-side' },
            element(
                'nav',
                { 'aria-label': say('Pages') },
                links.map((link) => link.node),
            ),
            actions,
            languageSwitch(),
        ),
    );
    return {
        node,
        show(route) {
            for (const link of links) {
                if (link.page === route.page) {
                    link.node.setAttribute('aria-current', 'page');
                } else if (link.page === 'home' && route.page === 'results') {
                    link.node.setAttribute('aria-current', 'true');
                } else {
                    link.node.removeAttribute('aria-current');
                }
            }
        },
    };
}
