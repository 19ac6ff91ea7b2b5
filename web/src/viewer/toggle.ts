import { element } from '../page/element';

export function toggle(label: string, on: boolean, onChange: (on: boolean) => void): HTMLElement {
    const input = element('input', { type: 'checkbox', checked: on });
    input.addEventListener('change', () => onChange(input.checked));
    return element('label', { class: 'switch' }, input, element('span', {}, label));
}
