import { defineConfig, type Plugin } from 'vite';

const kServer = 'http://127.0.0.1:8080';

/** The built page forbids itself what it never needs: other origins, inline scripts and styles. */
const kContentSecurityPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; " +
    "base-uri 'none'; form-action 'none'";

/** Only in the build: the development server itself relies on inline styles. */
function contentSecurityPolicy(): Plugin {
    return {
        name: 'content-security-policy',
        apply: 'build',
        transformIndexHtml: () => [
            {
                tag: 'meta',
                attrs: {
                    'http-equiv': 'Content-Security-Policy',
                    content: kContentSecurityPolicy,
                },
                injectTo: 'head-prepend',
            },
        ],
    };
}

export default defineConfig({
    // The page is found under any path that a proxy gives it.
    base: './',
    plugins: [contentSecurityPolicy()],
    server: { proxy: { '/v1': kServer, '/openapi.yaml': kServer } },
    build: {
        target: 'es2022',
        assetsInlineLimit: 0,
        modulePreload: { polyfill: false },
        chunkSizeWarningLimit: 800,
        rolldownOptions: { input: ['index.html', 'embed.html'] },
    },
});
