/** Properties by which {@link element} tells what to do: see there. */
export type Attributes = Record<
    string,
    string | number | boolean | null | undefined | ((event: never) => void)
>;

export type Child = Node | string | number | null | undefined | false | Child[];

const kSvgNamespace = 'http://www.w3.org/2000/svg';

function set(node: Element, name: string, value: Attributes[string]): void {
    if (value === null || value === undefined || value === false) {
        return;
    }
    if (typeof value === 'function') {
        node.addEventListener(name, value as unknown as EventListener);
    } else if (name.startsWith('--') && 'style' in node) {
        // Through the object model, because the content security policy forbids style attributes.
        (node as HTMLElement).style.setProperty(name, String(value));
    } else {
        node.setAttribute(name, value === true ? '' : String(value));
    }
}

/** Text stays text: nothing that a server says is ever read as markup. */
export function append(node: Element, ...children: Child[]): void {
    for (const child of children) {
        if (Array.isArray(child)) {
            append(node, ...child);
        } else if (child instanceof Node) {
            node.append(child);
        } else if (child !== null && child !== undefined && child !== false) {
            node.append(String(child));
        }
    }
}

/**
 * An element with its attributes, listeners and children in one expression. A function is a
 * listener for the event of that name, a name that starts with `--` a CSS variable, `true` a bare
 * attribute; `false`, `null` and `undefined` leave the attribute out.
 */
export function element<K extends keyof HTMLElementTagNameMap>(
    tag: K,
    attributes: Attributes = {},
    ...children: Child[]
): HTMLElementTagNameMap[K] {
    const node = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        set(node, name, value);
    }
    append(node, ...children);
    return node;
}

export function svg(tag: string, attributes: Attributes = {}, ...children: Child[]): SVGElement {
    const node = document.createElementNS(kSvgNamespace, tag) as SVGElement;
    for (const [name, value] of Object.entries(attributes)) {
        set(node, name, value);
    }
    append(node, ...children);
    return node;
}

export function replace(node: Element, ...children: Child[]): void {
    node.replaceChildren();
    append(node, ...children);
}
