import './styles/tokens.css';
import './styles/base.css';
import './styles/controls.css';
import './styles/notices_and_tables.css';
import './styles/start.css';
import './styles/gallery.css';
import './styles/uploads.css';
import { startApp } from './app';
import { speak, wantedLanguage } from './words/say';

const root = document.getElementById('app');
if (root) {
    // English should the table of another language not arrive.
    await speak(wantedLanguage()).catch(() => {});
    startApp(root);
}
