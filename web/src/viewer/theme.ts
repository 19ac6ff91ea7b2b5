import type { SurfaceColors } from './surface_material';

export interface ViewerTheme {
    surface: SurfaceColors;
    /** Branches and nodes without a counterpart. */
    unmatched: string;
    node: string;
    highlight: string;
    accent: string;
    /** Of what is measured. */
    measure: string;
    /** What parts fade towards. */
    faded: string;
}

function variable(name: string, fallback: string): string {
    const value = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
    return value === '' ? fallback : value;
}

/** The colours of the style sheet, which knows whether the page is light or dark. */
export function readViewerTheme(): ViewerTheme {
    return {
        surface: {
            body: variable('--viewer-body', '#8b97a0'),
            rim: variable('--viewer-rim', '#4a555e'),
            bodyOpacity: Number(variable('--viewer-body-opacity', '0.16')),
            rimOpacity: Number(variable('--viewer-rim-opacity', '0.6')),
        },
        unmatched: variable('--viewer-unmatched', '#9aa0a4'),
        node: variable('--viewer-node', '#30363b'),
        highlight: variable('--viewer-highlight', '#ffffff'),
        accent: readAccent(),
        measure: variable('--danger', '#a2342c'),
        faded: variable('--viewer-faded', '#d9dad4'),
    };
}

/** Returns what ends the subscription. */
export function onThemeChange(listener: () => void): () => void {
    const dark = matchMedia('(prefers-color-scheme: dark)');
    dark.addEventListener('change', listener);
    return () => dark.removeEventListener('change', listener);
}

export function readAccent(): string {
    return variable('--viewer-accent', '#1f8a76');
}
