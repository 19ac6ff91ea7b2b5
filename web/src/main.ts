import './styles/tokens.css';
import './styles/base.css';
import './styles/controls.css';
import './styles/notices_and_tables.css';
import './styles/start.css';
import './styles/gallery.css';
import './styles/results.css';
import './styles/dialog.css';
import './styles/uploads.css';
import { startApp } from './app';

const root = document.getElementById('app');
if (root) {
    startApp(root);
}
