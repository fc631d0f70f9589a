// The page of a shared file begins here: the recorded run is taken out of it, then it is shown as the page shows any.
import { mount } from 'svelte'
import '../theme.css'
import { look } from '../state/look.svelte'
import { startFrom } from '../link/link'
import { t } from '../texts/index.svelte'
import { fetchTranslation } from '../texts/translations.svelte'
import { meshBytes } from '../values/meshBytes'
import { carrierOf } from './carrier'
import { Film } from './film'
import { unpack } from './unpack'
import Player from './Player.svelte'

async function begin(target: HTMLElement): Promise<void> {
  await fetchTranslation()
  const film = new Film(await unpack(document.getElementById('run')?.textContent ?? ''))
  Object.assign(globalThis, { onikaRun: film }) // for whoever wants its numbers: onikaRun.instant(12.5)
  look.isFixed = true
  look.level = 'applications'
  meshBytes.of = (name) => Promise.resolve(film.mesh(name))
  await startFrom(() => carrierOf(film))
  mount(Player, { target })
}

const place = document.getElementById('app')
if (!place) throw new Error('the page has no element #app')
begin(place).catch((why: unknown) => {
  place.textContent = t('player.spoilt', { why: String(why) })
})
