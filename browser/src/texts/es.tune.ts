// Español: parámetros, sus juegos, y variables que se escriben a mano.
import type { enTune } from './en.tune'

export const esTune: Record<keyof typeof enTune, string> = {
  'tune.parameters': 'Parámetros',
  'tune.range': '{range} {unit}',
  'tune.default': 'por omisión {value}',
  'tune.sets': 'Juegos de parámetros…',
  'tune.setsTitle': 'Juegos de parámetros de {name}',
  'tune.setsAbout':
    'Un juego guarda con un nombre los parámetros de todas las tareas de aquí, en {path}. Al cambiar se toman todos sus valores, o ninguno.',
  'tune.noSets': 'Aún no se guarda ningún juego.',
  'tune.setName': 'Nombre de un juego nuevo',
  'tune.keep': 'Guardar como están ahora',
  'tune.now': 'ahora',
  'tune.switch': 'Cambiar',
  'tune.switchTo': 'Cambiar a {name}',
  'tune.isNow': 'como ahora',
  'tune.replace': 'Reemplazar',
  'tune.replaceBy': 'Reemplazar {name} por los parámetros como están ahora',
  'tune.remove': 'Quitar',
  'tune.removeSet': 'Quitar {name}; Ctrl+Z lo devuelve',
  'tune.parameter': 'Parámetro',
  'tune.onlyDifferent': 'Solo lo que difiere',
  'tune.allSame': 'Todos los juegos son como los parámetros ahora.',
  'tune.byHand': 'Nadie la escribe: escríbela a mano',
  'tune.handValue': 'Valor de {name}, Intro lo envía',
  'tune.handFrom': 'arrastrar de',
  'tune.handTo': 'a',
  'prefer.units': 'Unidades en formularios, tablas y gráficas; los archivos siguen en unidades SI',
  'prefer.angle_unit': 'Ángulos',
  'prefer.length_unit': 'Longitudes',
}
