import './styles/tokens.css';
import './styles/base.css';
import './styles/controls.css';
import './styles/notices_and_tables.css';
import './styles/embed.css';
import { createClient } from './api/client';
import { embeddedModel } from './gallery/embedded_model';
import { speak, wantedLanguage } from './words/say';

const root = document.getElementById('embed');
if (root) {
    await speak(wantedLanguage()).catch(() => {});
    const show = (): void => void embeddedModel(root, location.hash, createClient());
    addEventListener('hashchange', show);
    show();
}
