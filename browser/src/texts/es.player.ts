// Español: una ejecución grabada que está en un archivo y se reproduce sola; cómo se hace.
import type { enPlayer } from './en.player'

export const esPlayer: Record<keyof typeof enPlayer, string> = {
  'player.title': 'Ejecución de {name}',
  'player.about': 'Una ejecución grabada. Nada de aquí llega a un robot ni a una red.',
  'player.onlyLooks': 'Este archivo contiene una ejecución grabada: se puede mirar, y nada en él se puede cambiar.',
  'player.spoilt': 'Este archivo no se puede reproducir: {why}',
  'player.language': 'Idioma',
  'player.theme': 'Aspecto',
  'share.share': 'Compartir…',
  'share.hint': 'Hacer de esta grabación un archivo que se reproduce en cualquier navegador, sin red y sin Onika',
  'share.making': 'Haciendo el archivo…',
  'share.made': '{file} está hecho ({size}). Se reproduce en cualquier navegador.',
  'share.coarse': 'Para que el archivo sea pequeño, muestra un instante cada {seconds} s.',
}
