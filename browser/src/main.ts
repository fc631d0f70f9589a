// The page begins here: the look, then the shell.
import { mount } from 'svelte'
import App from './App.svelte'
import { fetchTranslation } from './texts/translations.svelte'
import './theme.css'

const place = document.getElementById('app')
if (!place) throw new Error('index.html has no element #app')
await fetchTranslation()
mount(App, { target: place })
