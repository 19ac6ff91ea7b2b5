import 'uplot/dist/uPlot.min.css';
import './styles/tokens.css';
import './styles/base.css';
import './styles/controls.css';
import './styles/notices_and_tables.css';
import './styles/start.css';
import './styles/gallery.css';
import './styles/results.css';
import './styles/viewer.css';
import './styles/parts.css';
import './styles/reports.css';
import { startApp } from './app';

const root = document.getElementById('app');
if (root) {
    startApp(root);
}
