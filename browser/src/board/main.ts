// The board of a class begins here.
import { mount } from 'svelte'
import { fetchTranslation } from '../texts/translations.svelte'
import '../theme.css'
import Board from './Board.svelte'

const target = document.getElementById('app')
if (!target) throw new Error('the page has no element #app')
await fetchTranslation()
mount(Board, { target })
