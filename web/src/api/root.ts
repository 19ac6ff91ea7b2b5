/** What stands before the server's paths: empty, or the path under which a proxy has the gallery. */
export const kRoot: string = new URL('.', document.baseURI).pathname.replace(/\/$/, '');
