import { describe, expect, it } from 'vitest';

/** The folders of src/ in the order in which one may use another: each those above it. */
const kLayers = ['words', 'api', 'page', 'viewer', 'gallery', 'reports', 'manage', ''] as const;
/** Side by side: neither knows of the other. */
const kApart: readonly (readonly [string, string])[] = [
    ['gallery', 'reports'],
    ['gallery', 'manage'],
    ['reports', 'manage'],
];

const kSources = import.meta.glob<string>('../src/**/*.ts', {
    query: '?raw',
    import: 'default',
    eager: true,
});

type Sources = Readonly<Record<string, string>>;

function sourcesOfThePage(): Sources {
    const sources: Record<string, string> = {};
    for (const [path, text] of Object.entries(kSources)) {
        sources[path.replace('../src/', '').replace(/\.ts$/, '')] = text;
    }
    return sources;
}

function folderOf(file: string): string {
    return file.includes('/') ? file.slice(0, file.indexOf('/')) : '';
}

/** Files of src/ that a file names, by `import … from`, `export … from` or `import(…)`. */
function importsOf(file: string, text: string): string[] {
    const named = text.matchAll(/(?:\bfrom\s*|\bimport\s*\(?\s*)['"](\.[^'"]*)['"]/g);
    return [...named].map(([, path]) => new URL(path ?? '', `file:///${file}`).pathname.slice(1));
}

/** Imports that lead to a folder further down the list, or aside. */
function backwardImports(sources: Sources): string[] {
    const rank = (file: string) => (kLayers as readonly string[]).indexOf(folderOf(file));
    return Object.entries(sources).flatMap(([from, text]) =>
        importsOf(from, text)
            .filter((to) => to in sources)
            .filter(
                (to) =>
                    rank(from) < 0 ||
                    rank(to) > rank(from) ||
                    kApart.some(
                        (pair) =>
                            folderOf(from) !== folderOf(to) &&
                            pair.includes(folderOf(from)) &&
                            pair.includes(folderOf(to)),
                    ),
            )
            .map((to) => `${from} → ${to}`),
    );
}

/** Files that need themselves by way of others, the way named. */
function circles(sources: Sources): string[] {
    const found: string[] = [];
    const done = new Set<string>();
    const follow = (file: string, way: readonly string[]): void => {
        if (way.includes(file)) {
            found.push([...way.slice(way.indexOf(file)), file].join(' → '));
            return;
        }
        if (!done.has(file)) {
            for (const next of importsOf(file, sources[file] ?? '')) {
                if (next in sources) {
                    follow(next, [...way, file]);
                }
            }
            done.add(file);
        }
    };
    for (const file of Object.keys(sources)) {
        follow(file, []);
    }
    return found;
}

/** three.js outside the viewer, uPlot outside the reports. */
function strayLibraries(sources: Sources): string[] {
    const homes = [
        { library: /['"]three(?:\/[^'"]*)?['"]/, home: 'viewer' },
        { library: /from ['"]uplot['"]/, home: 'reports' },
    ];
    return Object.entries(sources).flatMap(([file, text]) =>
        homes
            .filter(({ library, home }) => library.test(text) && folderOf(file) !== home)
            .map(({ home }) => `${file} uses what belongs to ${home}/`),
    );
}

describe('the check itself', () => {
    it('sees every kind of import', () => {
        const text = [
            "import { a } from '../api/a';",
            "import type { b } from './b';",
            "export { c } from '../page/c';",
            "const d = await import('../viewer/d');",
            "import './e';",
            "import uPlot from 'uplot';",
        ].join('\n');
        expect(importsOf('gallery/x', text)).toEqual([
            'api/a',
            'gallery/b',
            'page/c',
            'viewer/d',
            'gallery/e',
        ]);
    });

    it('blames an import that runs back, one aside, and a folder that it does not know', () => {
        const sources = {
            'page/a': "import { b } from '../gallery/b';",
            'gallery/b': "import { c } from '../reports/c';",
            'reports/c': "import { d } from '../gallery/d';",
            'gallery/d': "import { e } from '../page/e';",
            'page/e': '',
            'attic/f': "import { e } from '../page/e';",
        };
        expect(backwardImports(sources)).toEqual([
            'page/a → gallery/b',
            'gallery/b → reports/c',
            'reports/c → gallery/d',
            'attic/f → page/e',
        ]);
    });

    it('blames a circle of files', () => {
        const sources = {
            'page/a': "import type { B } from './b';",
            'page/b': "import { c } from './c';",
            'page/c': "import { a } from './a';",
        };
        expect(circles(sources)).toEqual(['page/a → page/b → page/c → page/a']);
    });

    it('blames a library away from home', () => {
        expect(strayLibraries({ 'page/a': "import { Scene } from 'three';" })).toHaveLength(1);
        expect(strayLibraries({ 'viewer/a': "import { Scene } from 'three';" })).toEqual([]);
    });
});

describe('the page', () => {
    const sources = sourcesOfThePage();

    it('is looked at as a whole', () => {
        expect(Object.keys(sources)).toContain('main');
        expect(importsOf('main', sources.main ?? '')).toContain('app');
    });

    it('has no import that runs back', () => {
        expect(backwardImports(sources)).toEqual([]);
    });

    it('has no circle of imports', () => {
        expect(circles(sources)).toEqual([]);
    });

    it('keeps each library in one folder', () => {
        expect(strayLibraries(sources)).toEqual([]);
    });
});
