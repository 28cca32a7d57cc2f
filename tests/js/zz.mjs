import { Curve } from "../../js/index.js";
import { core } from "../../js/init.js";
import { load } from "../../js/transfer.js";
import { takeIntersections } from "../../js/meetings.js";
const time=(f,n)=>{for(let i=0;i<20000;i++)f();let best=1e9;for(let k=0;k<3000;k++){const s=performance.now();for(let i=0;i<50;i++)f();best=Math.min(best,(performance.now()-s)/50*1e3);}return best.toFixed(2)};
const set={nine:[[[6.4, 4.8], [15, 5], [1, 4], [10, 4]],[[9.4, 0.4], [9.3, 10.3], [8.1, 0.1], [7.53125, 5.5]]],three:[[[0,0],[1,2],[2,-1],[3,1]],[[0,1],[1,0.5],[2,0.5],[3,0]]],one:[[[0,0],[1,1],[2,1],[3,0]],[[1,-1],[1.5,0],[1.5,1],[2,2]]],far:[[[0,0],[1,1],[2,1],[3,0]],[[11,-1],[11.5,0],[11.5,1],[12,2]]]};
for(const [n,[a,b]] of Object.entries(set)){
 const A=new Curve(a),B=new Curve(b); const f=A.controlPoints(), g=B.controlPoints();
 const ld=()=>{const v=load(f,8);for(let i=0;i<8;i++)v[8+i]=g[i];};
 const k=A.intersect(B).length;
 console.log(n,"all",time(()=>A.intersect(B),5000),"load",time(ld,5000),"load+core",time(()=>{ld();core().curve_intersect(4,4)},5000),"take",time(()=>takeIntersections(7*k),5000));
}
