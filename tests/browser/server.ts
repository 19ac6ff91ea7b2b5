import { type ChildProcess, execFileSync, spawn, spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

function fromRoot(path: string): string {
    return fileURLToPath(new URL(`../../${path}`, import.meta.url));
}

/** Where a program is that the tests cannot do without; `variable` overrides the build's own. */
function program(variable: string, path: string): string {
    const found = process.env[variable] ?? fromRoot(path);
    if (!existsSync(found)) {
        throw new Error(`${found} is missing: build it, or name another one in ${variable}`);
    }
    return found;
}

/** Far more than any of them takes on a busy machine. */
const kProgramTimeoutMs = 600_000;

/** Indexes `folder` into `index` with the command line program. */
export function buildIndex(index: string, folder: string, classes: string): void {
    const ossuary = program('OSSUARY_BIN', 'build/release/bin/ossuary');
    const { status, error } = spawnSync(
        ossuary,
        ['index', '--index', index, '--classes', classes, folder],
        { stdio: ['ignore', 'ignore', 'inherit'], timeout: kProgramTimeoutMs },
    );
    // 3: done, but for some files that cannot be indexed.
    if (status !== 0 && status !== 3) {
        throw error ?? new Error(`ossuary index ended with exit code ${status}`);
    }
}

/** Writes a model rigged by its skeleton. */
export function writeRig(model: string, glb: string): void {
    const ossuary = program('OSSUARY_BIN', 'build/release/bin/ossuary');
    execFileSync(ossuary, ['segment', model, '--out', glb], {
        stdio: ['ignore', 'ignore', 'inherit'],
        timeout: kProgramTimeoutMs,
    });
}

export interface Server {
    /** As in http://127.0.0.1:40123 */
    origin: string;
    stop(): Promise<void>;
}

const kStartTimeoutMs = 240_000;
const kStopTimeoutMs = 60_000;

function announcedOrigin(child: ChildProcess): Promise<string> {
    return new Promise((resolve, reject) => {
        let said = '';
        const timer = setTimeout(
            () => reject(new Error(`the server did not say where it listens: ${said}`)),
            kStartTimeoutMs,
        );
        child.stdout?.setEncoding('utf8');
        child.stdout?.on('data', (text: string) => {
            said += text;
            const origin = /listening on (http:\/\/\S+)/.exec(said)?.[1];
            if (origin) {
                clearTimeout(timer);
                resolve(origin);
            }
        });
        child.on('exit', (code) => {
            clearTimeout(timer);
            reject(new Error(`the server ended with exit code ${code}: ${said}`));
        });
    });
}

/** Of the servers that the tests start. */
export const kAdminKey = 'a-key-for-tests-0123456789';

/** Of readers, where a server has one. */
export const kReadKey = 'read-key-for-tests-0123';

export interface ServerSetting {
    /** Further options of the command line. */
    options?: readonly string[];
    environment?: Readonly<Record<string, string>>;
}

/** Serves `index` and the built gallery on a port that is free. */
export async function startServer(index: string, setting: ServerSetting = {}): Promise<Server> {
    const web = fromRoot('web/dist');
    if (!existsSync(`${web}/index.html`)) {
        throw new Error('web/dist is missing: run `npm run build` in web/ first');
    }
    const server = program('OSSUARY_SERVER', 'build/release/bin/ossuary-server');
    const options = ['--index', index, '--web', web, '--port', '0', ...(setting.options ?? [])];
    const child = spawn(server, options, {
        stdio: ['ignore', 'pipe', 'inherit'],
        env: { ...process.env, OSSUARY_ADMIN_KEY: kAdminKey, ...setting.environment },
    });
    const ended = new Promise<void>((resolve) => child.on('exit', () => resolve()));
    const origin = await announcedOrigin(child);
    return {
        origin,
        async stop() {
            child.kill('SIGTERM');
            const hard = setTimeout(() => child.kill('SIGKILL'), kStopTimeoutMs);
            await ended;
            clearTimeout(hard);
        },
    };
}
